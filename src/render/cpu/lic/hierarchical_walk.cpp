#include "render/cpu/lic/hierarchical.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/hierarchical_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/lic/contrast-inl.h"
#include "render/cpu/lic/jumps-inl.h"
#include "render/cpu/lic/trace-inl.h"
#include "render/cpu/lic/tube-inl.h"
#include "render/cpu/simd/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A trace in one direction while it walks step by step.
template <bool kHann>
struct Walker {
    JumpHierarchy& jumps;
    Traces trace;
    Walk walk;
    FlowVector before, here;  // The flow at the last two samples.
    VF length;                // The way from one to the other, pixels.
    FlowLookup look;          // The last sample's.
    float tubeUnitPx;         // halfNarrowing()'s.
    int counted = 0;          // Samples counted so far.

    // Adds the last sample, after `step` steps, and ends the trace where the flow turns.
    HWY_INLINE void count(const FlowCells& flow, int step)
    {
        if (counted == step) return;
        counted = step;
        const DF d;
        const VF narrowing = halfNarrowing(look.cell, look.taps, here, tubeUnitPx),
                 there = hn::Mul(walk.width, narrowing);
        const VF ds = hn::IfThenElseZero(trace.alive, hn::Mul(length, there)),
                 noise = hn::Mul(ds, hn::Mul(noiseAt(look), hn::Set(d, flow.noiseUnit)));
        walk.sum = hn::Add(walk.sum, noise);
        walk.lengthPx = hn::Add(walk.lengthPx, ds);
        if constexpr (kHann) {
            const Rotation& wave = jumps.rotations[std::size_t(step)];
            walk.cosSum = hn::MulAdd(noise, hn::Set(d, wave.cosine), walk.cosSum);
            walk.sinSum = hn::MulAdd(noise, hn::Set(d, wave.sine), walk.sinSum);
        }
        walk.width = hn::IfThenElse(trace.alive, hn::Mul(there, narrowing), walk.width);
        trace.alive = hn::And(trace.alive, flowsOn(before, here));
    }

    // Goes on to (dx, dy). The sample before is counted only now, while the cells of this one are on their way: what
    // they wait for must not wait for it (Zen 5).
    HWY_INLINE void visit(const FlowCells& flow, const LinkImage& links, VF dx, VF dy, int step)
    {
        look = visitFlow(flow, links, dx, dy, trace, [&]() AEOLIC_INLINE { count(flow, step - 1); });
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
        const MF hasFlow = start.alive;
        start.alive = hn::And(start.alive, flowsOn(origin, origin));
        const float tubePx = pass.streaks == Streaks::even ? vectorPx : 0;
        Walker<kHann> walkers[2] = {
            {pass.memory->directions[0], start, noWalk(), origin, origin, hn::Zero(d), {}, tubePx},
            {pass.memory->directions[1], start, noWalk(), origin, origin, hn::Zero(d), {}, -tubePx}};
        VF x0[2], y0[2];
        const auto firstHalf = [&](int k, int step) AEOLIC_INLINE {
            Walker<kHann>& w = walkers[k];
            const VF unit = hn::Set(d, w.jumps.sign * vectorPx);
            x0[k] = w.trace.dx;
            y0[k] = w.trace.dy;
            w.visit(flow, links, hn::MulAdd(w.here.x, unit, x0[k]), hn::MulAdd(w.here.y, unit, y0[k]), step);
            w.length = stepLength(w.here, hn::Set(d, vectorPx));  // Either half of the double step has that length.
        };
        const auto secondHalf = [&](int k, int step) AEOLIC_INLINE {
            Walker<kHann>& w = walkers[k];
            const VF twice = hn::Set(d, 2 * w.jumps.sign * vectorPx);
            w.visit(flow, links, hn::MulAdd(w.here.x, twice, x0[k]), hn::MulAdd(w.here.y, twice, y0[k]), step);
        };
        const auto storeRemainder = [&](int step) AEOLIC_INLINE {
            for (Walker<kHann>& w : walkers) {
                w.count(flow, step);
                storeJump<kHann>(w.jumps.remainder, at, w.trace, w.walk, open, hasFlow);
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
            storeJump<kHann>(*w.jumps.levels[0], at, w.trace, w.walk, open, hasFlow);
        }
    };
    forEachVectorNear(buffer, *pass.near, tile, walk, [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (JumpHierarchy& jumps : pass.memory->directions) {
            storeNoJump<kHann>(*jumps.levels[0], at);
            if (remainder > 0) storeNoJump<kHann>(jumps.remainder, at);
        }
    });
}

void walkDirectAny(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    pass.hann ? walkDirect<true>(buffer, flow, pass, tile) : walkDirect<false>(buffer, flow, pass, tile);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(walkDirectAny);

void walkDirectTile(const GBuffer& buffer, const FlowCells& flow, const HierarchicalPass& pass, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(walkDirectAny)(buffer, flow, pass, tile);
}

}  // namespace aeolic::cpu
#endif
