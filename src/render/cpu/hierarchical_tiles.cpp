#include <algorithm>

#include "render/cpu/hierarchical_pass.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/hierarchical_tiles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/contrast-inl.h"
#include "render/cpu/jumps-inl.h"
#include "render/cpu/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE std::ptrdiff_t indexOf(const GBuffer& buffer, int x, int y)
{
    return (y - buffer.valid().y0) * buffer.flow.stride() + (x - buffer.valid().x0);
}

HWY_INLINE bool anyFlow(const GBuffer& buffer, std::ptrdiff_t at)
{
    return !hn::AllTrue(DU(), hn::Eq(hn::LoadU(DU(), buffer.flow.origin() + at), hn::Zero(DU())));
}

// Where the pixel and its eight neighbours are linked to all of theirs.
HWY_INLINE MU openAt(const GBuffer& buffer, std::ptrdiff_t at)
{
    const hn::Rebind<std::uint8_t, DU> d8;
    auto all = hn::Set(d8, std::uint8_t{0xFF});
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column)
            all = hn::And(all, hn::LoadU(d8, buffer.links.origin() + at + row * buffer.links.stride() + column));
    return hn::Eq(hn::PromoteTo(DU(), all), hn::Set(DU(), 0xFFu));
}

// Calls body(index, x, y) for the vectors of pixels of a tile that have any flow, empty(index, x, y) for the others.
template <class Body, class Empty>
HWY_INLINE void forEachVector(const GBuffer& buffer, const Extent& tile, const Body& body, const Empty& empty)
{
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; x += int(hn::Lanes(DF()))) {
            const std::ptrdiff_t at = indexOf(buffer, x, y);
            anyFlow(buffer, at) ? body(at, x, y) : empty(at, x, y);
        }
}

// The same for those near flow alone.
template <class Body, class Empty>
HWY_INLINE void forEachVectorNear(const GBuffer& buffer, const NearFlow& near, const Extent& tile, const Body& body,
                                  const Empty& empty)
{
    for (int y = tile.y0; y < tile.y1; ++y) {
        const ColumnSpan columns = near.at(y);
        const int x0 = std::max(tile.x0, columns.x0), x1 = std::min(tile.x1, columns.x1);
        forEachVector(buffer, {x0, y, x1, y + 1}, body, empty);
    }
}

// A trace in one direction while it walks step by step.
template <bool kHann>
struct Walker {
    JumpHierarchy& jumps;
    Traces trace;
    Walk walk;
    FlowVector before, here;  // At the last two samples.
    VF length;                // From one to the other, in pixels.
    FlowLookup look;          // Of the last.
    int counted = 0;          // Samples.

    // Adds the last sample, after `step` steps, and ends the trace where the flow turns.
    HWY_INLINE void count(const FlowCells& flow, int step)
    {
        if (counted == step) return;
        counted = step;
        const DF d;
        const VF ds = hn::IfThenElseZero(trace.alive, length),
                 noise = hn::Mul(ds, hn::Mul(noiseAt(look), hn::Set(d, flow.noiseUnit)));
        walk.sum = hn::Add(walk.sum, noise);
        walk.lengthPx = hn::Add(walk.lengthPx, ds);
        if constexpr (kHann) {
            const Rotation& wave = jumps.rotations[std::size_t(step)];
            walk.cosSum = hn::MulAdd(noise, hn::Set(d, wave.cosine), walk.cosSum);
            walk.sinSum = hn::MulAdd(noise, hn::Set(d, wave.sine), walk.sinSum);
        }
        trace.alive = hn::And(trace.alive, flowsOn(before, here));
    }

    // Goes on to (dx, dy). The sample before is counted only now, while the cells of this one are on their way: what
    // they wait for must not wait for it (Zen 5).
    HWY_INLINE void visit(const FlowCells& flow, const LinkImage& links, VF dx, VF dy, int step)
    {
        FlowLookup next = lookUpFlow(flow, links, dx, dy, trace);
        count(flow, step - 1);
        look = next;
        moveTo(look, links, trace);
        before = here;
        here = vectorAt(look, trace);
    }
};

// Walks the first steps one by one. Second-order steps two pixels long whose middles serve as samples too: every
// look-up is both a Runge-Kutta stage and a noise sample, half the cost of unit RK2 steps at nearly their accuracy.
// Both directions at once, so that one's arithmetic hides the other's loads.
template <bool kHann>
void walkDirect(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    const LinkImage links(buffer);
    const DF d;
    const int steps = pass.plan->direct, remainder = pass.plan->remainder;
    const float vectorPx = vectorUnitPx(buffer);
    const auto walk = [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        prefetchBelow(flow.cells, at, steps + 1, hn::Lanes(d));
        for (const JumpHierarchy& jumps : pass.memory->directions) prefetchToWrite<kHann>(*jumps.levels[0], at);
        const FlowVector origin = flowAtPixel(buffer, at).vector;
        const MU open = openAt(buffer, at);
        Traces start = startTraces(buffer, links, at);
        start.alive = hn::And(start.alive, flowsOn(origin, origin));
        Walker<kHann> walkers[2] = {{pass.memory->directions[0], start, noWalk(), origin, origin, hn::Zero(d), {}},
                                    {pass.memory->directions[1], start, noWalk(), origin, origin, hn::Zero(d), {}}};
        VF x0[2], y0[2];
        const auto firstHalf = [&](int k, int step) AEOLIC_INLINE {
            Walker<kHann>& w = walkers[k];
            const VF unit = hn::Set(d, w.jumps.sign * vectorPx);
            x0[k] = w.trace.dx;
            y0[k] = w.trace.dy;
            w.visit(flow, links, hn::MulAdd(w.here.x, unit, x0[k]), hn::MulAdd(w.here.y, unit, y0[k]), step);
            w.length = stepLength(w.here, hn::Set(d, vectorPx));  // Of either half of the double step.
        };
        const auto secondHalf = [&](int k, int step) AEOLIC_INLINE {
            Walker<kHann>& w = walkers[k];
            const VF twice = hn::Set(d, 2 * w.jumps.sign * vectorPx);
            w.visit(flow, links, hn::MulAdd(w.here.x, twice, x0[k]), hn::MulAdd(w.here.y, twice, y0[k]), step);
        };
        const auto storeRemainder = [&](int step) AEOLIC_INLINE {
            for (Walker<kHann>& w : walkers) {
                w.count(flow, step);
                storeJump<kHann>(w.jumps.remainder, at, w.trace, w.walk, open);
            }
        };
        for (int i = 1; i <= steps; i += 2) {
            firstHalf(0, i);
            firstHalf(1, i);
            if (i == remainder) storeRemainder(i);
            if (i == steps) break;
            secondHalf(0, i + 1);
            secondHalf(1, i + 1);
            if (i + 1 == remainder) storeRemainder(i + 1);
        }
        for (Walker<kHann>& w : walkers) {
            w.count(flow, steps);
            storeJump<kHann>(*w.jumps.levels[0], at, w.trace, w.walk, open);
        }
    };
    forEachVectorNear(buffer, *pass.near, tile, walk, [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (JumpHierarchy& jumps : pass.memory->directions) {
            storeNoJump<kHann>(*jumps.levels[0], at);
            if (remainder > 0) storeNoJump<kHann>(jumps.remainder, at);
        }
    });
}

template <bool kHann>
HWY_INLINE bool anyAlive(const JumpWalker<kHann> (&walkers)[2])
{
    return !hn::AllFalse(DF(), hn::Or(walkers[0].trace.alive, walkers[1].trace.alive));
}

// Joins `radix` jumps of one level to one of the next, both directions at once.
template <bool kHann>
void joinJumps(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    const LinkImage links(buffer);
    auto& directions = pass.memory->directions;
    const int stride = directions[0].levels[from]->stride;
    const auto join = [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (const JumpHierarchy& jumps : directions) {
            prefetchBelow<kHann>(*jumps.levels[from], at, (radix - 1) * stride + 1);
            prefetchToWrite<kHann>(*jumps.levels[from + 1], at);
        }
        const Traces start = startTraces(buffer, links, at);
        JumpWalker<kHann> walkers[2];
        for (JumpWalker<kHann>& w : walkers) w.trace = start, w.walk = noWalk();
        for (int k = 0; k < 2; ++k) walkers[k].first(*directions[std::size_t(k)].levels[from], at);
        const auto next = [&](int k, int j) AEOLIC_INLINE {
            const JumpHierarchy& jumps = directions[std::size_t(k)];
            walkers[k].next(*jumps.levels[from], links, kHann ? jumps.rotations[std::size_t(j * stride)] : Rotation{});
        };
        for (int j = 1; j < radix && anyAlive(walkers); ++j) {
            next(0, j);
            next(1, j);
        }
        const MU open = openAt(buffer, at);
        for (int k = 0; k < 2; ++k) {
            JumpWalker<kHann>& w = walkers[k];
            w.count(links);
            settle(links, w.trace);
            storeJump<kHann>(*directions[std::size_t(k)].levels[from + 1], at, w.trace, w.walk, open);
        }
    };
    forEachVectorNear(buffer, *pass.near, tile, join, [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (JumpHierarchy& jumps : directions) storeNoJump<kHann>(*jumps.levels[from + 1], at);
    });
}

// The kernel's full length in both directions, from the highest level down.
template <bool kHann>
HWY_INLINE void walkAll(const LinkImage& links, const HierarchicalPass& pass, std::ptrdiff_t at,
                        JumpWalker<kHann> (&walkers)[2])
{
    bool first = true;
    int walked = 0;
    const auto jump = [&](int k, const JumpLevel& level) AEOLIC_INLINE {
        const JumpHierarchy& jumps = pass.memory->directions[std::size_t(k)];
        walkers[k].next(level, links, kHann ? jumps.rotations[std::size_t(walked)] : Rotation{});
    };
    const auto both = [&](const JumpLevel& down, const JumpLevel& up) AEOLIC_INLINE {
        if (first) {
            walkers[0].first(down, at);
            walkers[1].first(up, at);
        } else if (anyAlive(walkers)) {
            jump(0, down);
            jump(1, up);
        }
        first = false;
        walked += down.stride;
    };
    const auto& directions = pass.memory->directions;
    for (std::size_t level = pass.plan->digits.size(); level-- > 0;)
        for (int k = 0; k < pass.plan->digits[level]; ++k)
            both(*directions[0].levels[level], *directions[1].levels[level]);
    if (pass.plan->remainder > 0) both(directions[0].remainder, directions[1].remainder);
    for (JumpWalker<kHann>& w : walkers) w.count(links);
}

// Both directions' sums and the pixel's own sample to its LIC value.
template <bool kHann>
void finish(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    const DF d;
    const DU du;
    const LinkImage links(buffer);
    const std::size_t top = pass.plan->digits.size() - 1;
    const int reach = (pass.plan->digits[top] - 1) * pass.plan->stride(top) + 1;
    const auto finishVector = [&](std::ptrdiff_t at, int x, int y) AEOLIC_INLINE {
        for (const JumpHierarchy& jumps : pass.memory->directions) prefetchBelow<kHann>(*jumps.levels[top], at, reach);
        const Traces start = startTraces(buffer, links, at);
        JumpWalker<kHann> walkers[2];
        for (JumpWalker<kHann>& w : walkers) w.trace = start, w.walk = noWalk();
        walkAll<kHann>(links, pass, at, walkers);
        const Walk &down = walkers[0].walk, &up = walkers[1].walk;
        const FlowSample origin = flowAtPixel(buffer, at);
        const VF own = ownLength(origin.vector, vectorUnitPx(buffer));
        VF sum = hn::Add(down.sum, up.sum);
        if constexpr (kHann) {
            // (1 + cos(angle - phase)) / 2 from the plain sum and the two waves.
            const VF cosSum = hn::Add(down.cosSum, up.cosSum), sinSum = hn::Add(down.sinSum, up.sinSum);
            const VF wave =
                hn::MulAdd(hn::Set(d, pass.phaseCosine), cosSum, hn::Mul(hn::Set(d, pass.phaseSine), sinSum));
            sum = hn::Mul(hn::Set(d, 0.5f), hn::Add(sum, wave));
        }
        sum = hn::MulAdd(hn::Mul(own, hn::Set(d, pass.ownWeight)), origin.noise, sum);
        const VF length = hn::Add(own, hn::Add(down.lengthPx, up.lengthPx));
        const auto active = hn::RebindMask(d, hn::Ne(hn::LoadU(du, buffer.flow.origin() + at), hn::Zero(du)));
        hn::StoreU(hn::IfThenElseZero(active, licValue(sum, length, pass.contrast)), d, pass.out->row(y) + x);
    };
    forEachVector(buffer, tile, finishVector, [&](std::ptrdiff_t, int x, int y) AEOLIC_INLINE {
        hn::StoreU(hn::Zero(d), d, pass.out->row(y) + x);
    });
}

void walkDirectAny(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    pass.hann ? walkDirect<true>(buffer, flow, pass, tile) : walkDirect<false>(buffer, flow, pass, tile);
}
void joinJumpsAny(const GBuffer& buffer, const HierarchicalPass& pass, std::size_t from, int radix, const Extent& tile)
{
    pass.hann ? joinJumps<true>(buffer, pass, from, radix, tile) : joinJumps<false>(buffer, pass, from, radix, tile);
}
void finishAny(const GBuffer& buffer, const HierarchicalPass& pass, const Extent& tile)
{
    pass.hann ? finish<true>(buffer, pass, tile) : finish<false>(buffer, pass, tile);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(walkDirectAny);
HWY_EXPORT(joinJumpsAny);
HWY_EXPORT(finishAny);

void walkDirectTile(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(walkDirectAny)(buffer, flow, pass, tile);
}

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
