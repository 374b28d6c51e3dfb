#include "render/cpu/lic/hierarchical.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/hierarchical_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/lic/contrast-inl.h"
#include "render/cpu/lic/jumps-inl.h"
#include "render/cpu/lic/trace-inl.h"
#include "render/cpu/simd/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A trace in one direction while it walks step by step. Of a sample only its counts are kept, and not the texels
// looked up: those are too many for the registers.
template <bool kWeighted, bool kEven>
struct Walker {
    JumpHierarchy& jumps;
    Traces trace;
    Walk walk;
    FlowVector before, here;  // The flow at the last two samples.
    VF length;                // The way from one to the other, pixels.
    VF noise, narrowing;      // Of the last sample, and how the stream tube narrows in half a step there.
    float vectorPx;           // Pixels per unit of a vector; negative upstream.

    // Adds the last sample, after `step` steps, and ends the trace where the flow turns.
    HWY_INLINE void count(int step)
    {
        const DF d;
        const VF there = hn::Mul(walk.width, narrowing);
        const VF ds = hn::IfThenElseZero(trace.alive, hn::Mul(length, there)), gained = hn::Mul(ds, noise);
        walk.sum = hn::Add(walk.sum, gained);
        walk.lengthPx = hn::Add(walk.lengthPx, ds);
        if constexpr (kWeighted) {
            const Turn& by = jumps.turns[std::size_t(step)];
            walk.first = hn::MulAdd(gained, hn::Set(d, by.aa), walk.first);
            walk.second = hn::MulAdd(gained, hn::Set(d, by.ba), walk.second);
        }
        walk.width = hn::IfThenElse(trace.alive, hn::Mul(there, narrowing), walk.width);
        trace.alive = hn::And(trace.alive, flowsOn(before, here));
    }

    // Asks for the flow `steps` of the last sample's vectors from (x, y).
    HWY_INLINE FlowLookup ask(const FlowCells& flow, const LinkImage& links, VF x, VF y, float steps) const
    {
        const VF by = hn::Set(DF(), steps * vectorPx);
        return lookUpFlow(flow, links, hn::MulAdd(here.x, by, x), hn::MulAdd(here.y, by, y), trace);
    }

    // Goes where it asked, which is the sample after `step` steps. The sample before is counted only now, while the
    // cells of this one are on their way: what they wait for must not wait for it (Zen 5).
    HWY_INLINE void go(const FlowCells& flow, const LinkImage& links, FlowLookup& look, int step)
    {
        count(step - 1);
        moveTo(look, links, trace);
        before = here;
        here = vectorAt(look, trace);
        noise = hn::Mul(noiseAt(look), hn::Set(DF(), flow.noiseUnit));
        if constexpr (kEven) narrowing = halfNarrowing(look.cell, look.taps, here, vectorPx);
    }
};

// A walker that has not begun. What its first sample finds to count is nothing.
template <bool kWeighted, bool kEven>
HWY_INLINE Walker<kWeighted, kEven> startWalker(JumpHierarchy& jumps, const Traces& trace, const FlowVector& origin,
                                                float unitPx)
{
    const VF zero = hn::Zero(DF()), one = hn::Set(DF(), 1.0f);
    return {jumps, trace, noWalk(), origin, origin, zero, zero, one, jumps.sign * unitPx};
}

// Walks the first steps one by one. Second-order steps two pixels long whose middles serve as samples too: every
// look-up is both a Runge-Kutta stage and a noise sample, half the cost of unit RK2 steps at nearly their accuracy.
// Both directions at once, so that one's arithmetic hides the other's loads: each asks before either goes.
template <bool kWeighted, bool kEven>
void walkDirect(const HierarchicalPass& pass, const FlowCells& flow, const Extent& tile)
{
    using OneWay = Walker<kWeighted, kEven>;
    const GBuffer& buffer = pass.buffer;
    const LinkImage links(buffer);
    const DF d;
    const int steps = pass.memory.plan.direct, remainder = pass.memory.plan.remainder;
    const float vectorPx = vectorUnitPx(buffer);
    const auto walk = [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        prefetchBelow(flow.cells, at, steps + 1, hn::Lanes(d));
        for (const JumpHierarchy& jumps : pass.memory.directions) prefetchToWrite<kWeighted>(jumps.levels[0], at);
        const FlowVector origin = flowAtPixel(buffer, at).vector;
        const MU open = openAt(buffer, at);
        Traces start = startTraces(buffer, links, at);
        const MF hasFlow = start.alive;
        start.alive = hn::And(start.alive, flowsOn(origin, origin));
        auto down = startWalker<kWeighted, kEven>(pass.memory.directions[0], start, origin, vectorPx);
        auto up = startWalker<kWeighted, kEven>(pass.memory.directions[1], start, origin, vectorPx);
        // A copy is asked: a walker that goes on counts its last sample then.
        const auto store = [&](OneWay w, JumpLevel& level, int step) AEOLIC_INLINE {
            w.count(step);
            storeJump<kWeighted>(level, at, w.trace, w.walk, open, hasFlow);
        };
        const auto storeRemainder = [&](int step) AEOLIC_INLINE {
            store(down, down.jumps.remainder, step);
            store(up, up.jumps.remainder, step);
        };
        for (int i = 1; i <= steps; i += 2) {
            const VF downX = down.trace.dx, downY = down.trace.dy, upX = up.trace.dx, upY = up.trace.dy;
            FlowLookup downHalf = down.ask(flow, links, downX, downY, 1), upHalf = up.ask(flow, links, upX, upY, 1);
            const auto half = [&](OneWay& w, FlowLookup& look) AEOLIC_INLINE {
                w.go(flow, links, look, i);
                w.length = stepLength(w.here, hn::Set(d, vectorPx));  // Either half of the double step has that length.
            };
            half(down, downHalf);
            half(up, upHalf);
            if (i == remainder) storeRemainder(i);
            if (i == steps) break;
            FlowLookup downWhole = down.ask(flow, links, downX, downY, 2), upWhole = up.ask(flow, links, upX, upY, 2);
            down.go(flow, links, downWhole, i + 1);
            up.go(flow, links, upWhole, i + 1);
            if (i + 1 == remainder) storeRemainder(i + 1);
        }
        store(down, down.jumps.levels[0], steps);
        store(up, up.jumps.levels[0], steps);
    };
    forEachVectorNear(buffer, pass.near, tile, walk, [&](std::ptrdiff_t at, int, int) AEOLIC_INLINE {
        for (JumpHierarchy& jumps : pass.memory.directions) {
            storeNoJump<kWeighted>(jumps.levels[0], at);
            if (remainder > 0) storeNoJump<kWeighted>(jumps.remainder, at);
        }
    });
}

void walkDirectAny(const HierarchicalPass& pass, const FlowCells& flow, const Extent& tile)
{
    const bool even = pass.streaks == Streaks::even;
    if (pass.kernel.weighted())
        even ? walkDirect<true, true>(pass, flow, tile) : walkDirect<true, false>(pass, flow, tile);
    else
        even ? walkDirect<false, true>(pass, flow, tile) : walkDirect<false, false>(pass, flow, tile);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(walkDirectAny);

void walkDirectTile(const HierarchicalPass& pass, const FlowCells& flow, const Extent& tile)
{
    HWY_DYNAMIC_DISPATCH(walkDirectAny)(pass, flow, tile);
}

}  // namespace aeolic::cpu
#endif
