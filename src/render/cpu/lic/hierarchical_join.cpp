#include "render/cpu/lic/hierarchical.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/hierarchical_join.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/lic/contrast-inl.h"
#include "render/cpu/lic/jump_walker-inl.h"
#include "render/cpu/lic/trace-inl.h"
#include "render/cpu/simd/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Both directions of a trace.
template <bool kWeighted>
struct BothWays {
    JumpWalker<kWeighted> down, up;

    HWY_INLINE explicit BothWays(const Traces& start)
    {
        down.trace = up.trace = start;
        down.walk = up.walk = noWalk();
        down.gain = up.gain = noGain();
    }
    HWY_INLINE bool anyAlive() const { return !hn::AllFalse(DF(), hn::Or(down.trace.alive, up.trace.alive)); }

    // Begins both walks, with the jumps that start on the pixels `at` themselves.
    HWY_INLINE void first(const JumpLevel& downLevel, const JumpLevel& upLevel, std::ptrdiff_t at)
    {
        firstJump<kWeighted>(downLevel, at, down.trace, down.walk);
        firstJump<kWeighted>(upLevel, at, up.trace, up.walk);
    }

    // Jumps in both directions, turned by the steps walked before. Both are asked for before either is taken.
    HWY_INLINE void next(const JumpLevel& downLevel, const JumpLevel& upLevel, const LinkImage& links,
                         const std::array<JumpHierarchy, 2>& directions, int walked)
    {
        const auto turn = [&](std::size_t k)
                              AEOLIC_INLINE { return kWeighted ? directions[k].turns[std::size_t(walked)] : Turn{}; };
        JumpLookup downJump = lookUpJump(downLevel, links, down.trace), upJump = lookUpJump(upLevel, links, up.trace);
        down.next(downLevel, downJump, links, turn(0));
        up.next(upLevel, upJump, links, turn(1));
    }
};

// Joins jumps of one level to one of the next, both directions at once.
template <bool kWeighted>
void joinJumps(const HierarchicalPass& pass, std::size_t from, const Extent& tile)
{
    const GBuffer& buffer = pass.buffer;
    const LinkImage links(buffer);
    auto& directions = pass.memory.directions;
    const int stride = directions[0].levels[from].stride, radix = pass.memory.plan.radix[from];
    const auto join = [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (const JumpHierarchy& jumps : directions) {
            prefetchBelow<kWeighted>(jumps.levels[from], at, (radix - 1) * stride + 1);
            prefetchToWrite<kWeighted>(jumps.levels[from + 1], at);
        }
        const Traces start = startTraces(buffer, links, at);
        BothWays<kWeighted> walkers(start);
        walkers.first(directions[0].levels[from], directions[1].levels[from], at);
        for (int j = 1; j < radix && walkers.anyAlive(); ++j)
            walkers.next(directions[0].levels[from], directions[1].levels[from], links, directions, j * stride);
        const MU open = openAt(buffer, at);
        const auto store = [&](JumpWalker<kWeighted>& w, JumpHierarchy& jumps) AEOLIC_INLINE {
            w.count(links);
            settle(links, w.trace);
            storeJump<kWeighted>(jumps.levels[from + 1], at, w.trace, w.walk, open, start.alive);
        };
        store(walkers.down, directions[0]);
        store(walkers.up, directions[1]);
    };
    forEachVectorNear(buffer, pass.near, tile, join, [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (JumpHierarchy& jumps : directions) storeNoJump<kWeighted>(jumps.levels[from + 1], at);
    });
}

// The kernel's full length in both directions, from the highest level down.
template <bool kWeighted>
HWY_INLINE void walkAll(const LinkImage& links, const HierarchicalPass& pass, std::ptrdiff_t at,
                        BothWays<kWeighted>& walkers)
{
    int walked = 0;
    const auto& directions = pass.memory.directions;
    const auto both = [&](const JumpLevel& down, const JumpLevel& up) AEOLIC_INLINE {
        if (walked == 0)
            walkers.first(down, up, at);
        else if (walkers.anyAlive())
            walkers.next(down, up, links, directions, walked);
        walked += down.stride;
    };
    for (std::size_t level = pass.memory.plan.digits.size(); level-- > 0;)
        for (int k = 0; k < pass.memory.plan.digits[level]; ++k)
            both(directions[0].levels[level], directions[1].levels[level]);
    if (pass.memory.plan.remainder > 0) both(directions[0].remainder, directions[1].remainder);
    walkers.down.count(links);
    walkers.up.count(links);
}

// Both directions' sums and the pixel's own sample to its LIC value.
template <bool kWeighted>
void finish(const HierarchicalPass& pass, const Extent& tile)
{
    const DF d;
    const DU du;
    const GBuffer& buffer = pass.buffer;
    const LinkImage links(buffer);
    const std::size_t top = pass.memory.plan.digits.size() - 1;
    const int reach = (pass.memory.plan.digits[top] - 1) * pass.memory.plan.stride(top) + 1;
    const auto finishVector = [&](std::ptrdiff_t at, int x, int y) AEOLIC_INLINE {
        for (const JumpHierarchy& jumps : pass.memory.directions)
            prefetchBelow<kWeighted>(jumps.levels[top], at, reach);
        const Traces start = startTraces(buffer, links, at);
        BothWays<kWeighted> walkers(start);
        walkAll<kWeighted>(links, pass, at, walkers);
        const Walk &down = walkers.down.walk, &up = walkers.up.walk;
        const FlowSample origin = flowAtPixel(buffer, at);
        const VF own = ownLength(origin.vector, vectorUnitPx(buffer));
        VF sum = hn::Add(down.sum, up.sum);
        if constexpr (kWeighted) {
            const VF first = hn::Add(down.first, up.first), second = hn::Add(down.second, up.second);
            const VF weighted =
                hn::MulAdd(hn::Set(d, pass.kernel.ofFirst), first, hn::Mul(hn::Set(d, pass.kernel.ofSecond), second));
            sum = hn::Mul(hn::Set(d, 0.5f), hn::Add(hn::Mul(hn::Set(d, pass.kernel.ofPlain), sum), weighted));
        }
        sum = hn::MulAdd(hn::Mul(own, hn::Set(d, pass.ownWeight)), origin.noise, sum);

        const auto active = hn::RebindMask(d, hn::Ne(hn::LoadU(du, buffer.flow.origin() + at), hn::Zero(du)));
        const VF value = licValue(sum, own, down.lengthPx, down.width, up.lengthPx, up.width, pass.contrast);
        hn::StoreU(hn::IfThenElseZero(active, value), d, pass.out.row(y) + x);
    };
    for (int y = tile.y0; y < tile.y1; ++y)
        forEachVector(buffer, surfaceOf(buffer, tile, y), finishVector, [&](std::ptrdiff_t, int x, int) AEOLIC_INLINE {
            hn::StoreU(hn::Zero(d), d, pass.out.row(y) + x);
        });
}

void joinJumpsAny(const HierarchicalPass& pass, std::size_t from, const Extent& tile)
{
    pass.kernel.weighted() ? joinJumps<true>(pass, from, tile) : joinJumps<false>(pass, from, tile);
}
void finishAny(const HierarchicalPass& pass, const Extent& tile)
{
    pass.kernel.weighted() ? finish<true>(pass, tile) : finish<false>(pass, tile);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(joinJumpsAny);
HWY_EXPORT(finishAny);

void joinJumpsTile(const HierarchicalPass& pass, std::size_t from, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(joinJumpsAny)(pass, from, tile);
}

void finishTile(const HierarchicalPass& pass, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(finishAny)(pass, tile);
}

}  // namespace aeolic::cpu
#endif
