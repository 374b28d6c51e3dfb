#include "render/cpu/lic/hierarchical.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/hierarchical_join.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/lic/contrast-inl.h"
#include "render/cpu/lic/jump_walker-inl.h"
#include "render/cpu/lic/trace-inl.h"
#include "render/cpu/lic/tube-inl.h"
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

    // Jumps in both directions, turned by the steps walked before. Both are asked for before either is taken.
    HWY_INLINE void next(const JumpLevel& downLevel, const JumpLevel& upLevel, const LinkImage& links,
                         const std::array<JumpHierarchy, 2>& directions, int walked)
    {
        const auto turn = [&](std::size_t k)
                              AEOLIC_INLINE { return kWeighted ? directions[k].turns[std::size_t(walked)] : Turn{}; };
        JumpLookup downJump = down.ask(downLevel, links), upJump = up.ask(upLevel, links);
        down.next(downLevel, downJump, links, turn(0));
        up.next(upLevel, upJump, links, turn(1));
    }
};

// Joins `radix` jumps of one level to one of the next, both directions at once.
template <bool kWeighted>
void joinJumps(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    const LinkImage links(buffer);
    auto& directions = pass.memory->directions;
    const int stride = directions[0].levels[from]->stride;
    const auto join = [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (const JumpHierarchy& jumps : directions) {
            prefetchBelow<kWeighted>(*jumps.levels[from], at, (radix - 1) * stride + 1);
            prefetchToWrite<kWeighted>(*jumps.levels[from + 1], at);
        }
        const Traces start = startTraces(buffer, links, at);
        BothWays<kWeighted> walkers(start);
        walkers.down.first(*directions[0].levels[from], at);
        walkers.up.first(*directions[1].levels[from], at);
        for (int j = 1; j < radix && walkers.anyAlive(); ++j)
            walkers.next(*directions[0].levels[from], *directions[1].levels[from], links, directions, j * stride);
        const MU open = openAt(buffer, at);
        const auto store = [&](JumpWalker<kWeighted>& w, const JumpHierarchy& jumps) AEOLIC_INLINE {
            w.count(links);
            settle(links, w.trace);
            storeJump<kWeighted>(*jumps.levels[from + 1], at, w.trace, w.walk, open, start.alive);
        };
        store(walkers.down, directions[0]);
        store(walkers.up, directions[1]);
    };
    forEachVectorNear(buffer, *pass.near, tile, join, [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (JumpHierarchy& jumps : directions) storeNoJump<kWeighted>(*jumps.levels[from + 1], at);
    });
}

// The kernel's full length in both directions, from the highest level down.
template <bool kWeighted>
HWY_INLINE void walkAll(const LinkImage& links, const HierarchicalPass& pass, std::ptrdiff_t at,
                        BothWays<kWeighted>& walkers)
{
    bool first = true;
    int walked = 0;
    const auto& directions = pass.memory->directions;
    const auto both = [&](const JumpLevel& down, const JumpLevel& up) AEOLIC_INLINE {
        if (first) {
            walkers.down.first(down, at);
            walkers.up.first(up, at);
        } else if (walkers.anyAlive()) {
            walkers.next(down, up, links, directions, walked);
        }
        first = false;
        walked += down.stride;
    };
    for (std::size_t level = pass.plan->digits.size(); level-- > 0;)
        for (int k = 0; k < pass.plan->digits[level]; ++k)
            both(*directions[0].levels[level], *directions[1].levels[level]);
    if (pass.plan->remainder > 0) both(directions[0].remainder, directions[1].remainder);
    walkers.down.count(links);
    walkers.up.count(links);
}

// Both directions' sums and the pixel's own sample to its LIC value.
template <bool kWeighted>
void finish(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    const DF d;
    const DU du;
    const LinkImage links(buffer);
    const std::size_t top = pass.plan->digits.size() - 1;
    const int reach = (pass.plan->digits[top] - 1) * pass.plan->stride(top) + 1;
    const auto finishVector = [&](std::ptrdiff_t at, int x, int y) AEOLIC_INLINE {
        for (const JumpHierarchy& jumps : pass.memory->directions)
            prefetchBelow<kWeighted>(*jumps.levels[top], at, reach);
        const Traces start = startTraces(buffer, links, at);
        BothWays<kWeighted> walkers(start);
        walkAll<kWeighted>(links, pass, at, walkers);
        const Walk &down = walkers.down.walk, &up = walkers.up.walk;
        const FlowSample origin = flowAtPixel(buffer, at);
        const VF own = ownLength(origin.vector, vectorUnitPx(buffer));
        VF sum = hn::Add(down.sum, up.sum);
        if constexpr (kWeighted) {
            const VF first = hn::Add(down.first, up.first), second = hn::Add(down.second, up.second);
            const VF weighted = hn::MulAdd(hn::Set(d, pass.ofFirst), first, hn::Mul(hn::Set(d, pass.ofSecond), second));
            sum = hn::Mul(hn::Set(d, 0.5f), hn::Add(hn::Mul(hn::Set(d, pass.ofPlain), sum), weighted));
        }
        sum = hn::MulAdd(hn::Mul(own, hn::Set(d, pass.ownWeight)), origin.noise, sum);
        const VF length = hn::Add(own, hn::Add(down.lengthPx, up.lengthPx));
        const VF effective = effectivePixels(length, own, down.lengthPx, down.width, up.lengthPx, up.width);
        const auto active = hn::RebindMask(d, hn::Ne(hn::LoadU(du, buffer.flow.origin() + at), hn::Zero(du)));
        VF value = licValue(sum, length, effective, pass.contrast);
        if (kWeighted && pass.contrast.phased())
            value = hn::Mul(value, phaseGain(own, down.lengthPx, up.lengthPx, pass.contrast));
        hn::StoreU(hn::IfThenElseZero(active, value), d, pass.out->row(y) + x);
    };
    for (int y = tile.y0; y < tile.y1; ++y)
        forEachVector(buffer, surfaceOf(buffer, tile, y), finishVector, [&](std::ptrdiff_t, int x, int) AEOLIC_INLINE {
            hn::StoreU(hn::Zero(d), d, pass.out->row(y) + x);
        });
}

void joinJumpsAny(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    pass.weighted ? joinJumps<true>(buffer, pass, from, radix, tile)
                  : joinJumps<false>(buffer, pass, from, radix, tile);
}
void finishAny(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    pass.weighted ? finish<true>(buffer, pass, tile) : finish<false>(buffer, pass, tile);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(joinJumpsAny);
HWY_EXPORT(finishAny);

void joinJumpsTile(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(joinJumpsAny)(buffer, pass, from, radix, tile);
}

void finishTile(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(finishAny)(buffer, pass, tile);
}

}  // namespace aeolic::cpu
#endif
