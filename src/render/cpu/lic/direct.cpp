#include "render/cpu/lic/direct.h"

#include "base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/lic/direct.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/lic/contrast-inl.h"
#include "render/cpu/lic/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The vectors of a cell with the sign that is nearer to v's. The negative of a fine vector's word is the word of its
// negative.
HWY_INLINE void align(Block4<VU>& cell, const FlowVector& v)
{
    const auto aligned = [&](VU vector) AEOLIC_INLINE {
        const VF along = hn::MulAdd(cellX(vector), v.x, hn::Mul(cellY<FineCells>(vector), v.y));
        const VU negative = hn::Sub(hn::Zero(DU()), vector);
        return hn::IfThenElse(hn::RebindMask(DU(), hn::Lt(along, hn::Zero(DF()))), negative, vector);
    };
    cell = {aligned(cell.a), aligned(cell.b), aligned(cell.c), aligned(cell.d)};
}

// A trace in one direction.
struct Strand {
    Traces trace;
    FlowVector before, here;  // The flow at its last two places.
    VF length;                // The step between them in the image, pixels.
    VF noise, narrowing;      // At the last place: its noise, and how the stream tube narrows in half a step there.
    VF width;                 // The least of the stream tube so far, beside that at the start.
    VF lengthPx;              // Walked so far, weighted by the width.
    float weight = 0;         // How much the noise at the last place counts.

    // Adds what the last step gathered, and ends the trace where the flow turned.
    HWY_INLINE void count(VF& sum)
    {
        const VF there = hn::Mul(width, narrowing);
        const VF walked = hn::IfThenElseZero(trace.alive, hn::Mul(length, there));
        sum = hn::MulAdd(hn::Mul(walked, hn::Set(DF(), weight)), noise, sum);
        lengthPx = hn::Add(lengthPx, walked);
        width = hn::IfThenElse(trace.alive, hn::Mul(there, narrowing), width);
        trace.alive = hn::And(trace.alive, flowsOn(before, here));
    }

    // One step of the integrator. The step before is counted only when the first look-up is on its way, so that no
    // look-up waits for the counting. Of a step only the counts are kept, and not the texels looked up: those are too
    // many for the registers. `tubeUnitPx`: halfNarrowing()'s; 0 leaves all widths as they are.
    template <Integrator integrator, bool axial, class Cells>
    HWY_INLINE void step(const Cells& flow, const LinkImage& links, float unitPx, float tubeUnitPx, float byWeight,
                         VF& sum)
    {
        const DF d;
        const VF x = trace.dx, y = trace.dy, unit = hn::Set(d, unitPx), half = hn::Set(d, 0.5f * unitPx);
        const auto visit = [&](const FlowVector& v, VF by, const auto& meanwhile) AEOLIC_INLINE {
            LookupOf<Cells> look =
                visitFlow(flow, links, hn::MulAdd(v.x, by, x), hn::MulAdd(v.y, by, y), trace, meanwhile);
            if constexpr (axial) align(look.cell, v);
            return look;
        };
        const auto countBefore = [&]() AEOLIC_INLINE { count(sum); };
        const auto nothing = []() AEOLIC_INLINE {};
        const auto arrive = [&](const LookupOf<Cells>& look, const FlowVector& v) AEOLIC_INLINE {
            before = here;
            here = vectorAt(look, trace);
            noise = noiseAt(look);
            narrowing =
                tubeUnitPx == 0 ? hn::Set(d, 1.0f) : halfNarrowing<Cells>(look.cell, look.taps, here, tubeUnitPx);
            length = stepLength(v, hn::Abs(unit));
            weight = byWeight;
        };
        if constexpr (integrator == Integrator::euler) {
            const FlowVector v = here;
            arrive(visit(v, unit, countBefore), v);
        } else if constexpr (integrator == Integrator::rk2) {
            const FlowVector v = vectorAt(visit(here, half, countBefore), trace);
            arrive(visit(v, unit, nothing), v);
        } else {
            const FlowVector k1 = here, k2 = vectorAt(visit(k1, half, countBefore), trace),
                             k3 = vectorAt(visit(k2, half, nothing), trace),
                             k4 = vectorAt(visit(k3, unit, nothing), trace);
            const auto mean = [&](VF a, VF b, VF c, VF e) AEOLIC_INLINE {
                return hn::Mul(hn::Set(d, 1.0f / 6.0f), hn::MulAdd(hn::Set(d, 2.0f), hn::Add(b, c), hn::Add(a, e)));
            };
            const FlowVector v{mean(k1.x, k2.x, k3.x, k4.x), mean(k1.y, k2.y, k3.y, k4.y)};
            arrive(visit(v, unit, nothing), v);
        }
    }
};

// A trace that has not begun. What its first step finds to count is nothing.
HWY_INLINE Strand startStrand(const Traces& trace, const FlowVector& origin)
{
    const VF zero = hn::Zero(DF()), one = hn::Set(DF(), 1.0f);
    return {trace, origin, origin, zero, zero, one, one, zero};
}

// Follows the streamlines downstream and upstream at once to the end of the kernel or of the traces, adding up weighted
// noise, to the LIC value. One trace alone waits for its own loads; two chains in flight fill the gaps (1.7 times the
// speed).
template <Integrator integrator, bool axial, class Cells>
HWY_INLINE VF follow(const DirectPass& pass, const Cells& flow, const LinkImage& links, std::ptrdiff_t from)
{
    const DF d;
    const KernelWeights& kernel = pass.kernel;
    const FlowSample origin = flowAtPixel(pass.buffer, flow, from);
    const float vectorPx = vectorUnitPx(pass.buffer);
    const VF own = ownLength(origin.vector, vectorPx);
    VF noise = hn::Mul(hn::Mul(own, hn::Set(d, kernel.forward[0])), origin.noise);
    const float tubePx = pass.streaks == Streaks::even ? vectorPx : 0;
    Traces start = startTraces(pass.buffer, links, from);
    start.alive = hn::And(start.alive, flowsOn(origin.vector, origin.vector));
    Strand down = startStrand(start, origin.vector), up = startStrand(start, origin.vector);
    for (int i = 1; i <= kernel.steps && !hn::AllFalse(d, hn::Or(down.trace.alive, up.trace.alive)); ++i) {
        down.step<integrator, axial>(flow, links, vectorPx, tubePx, kernel.forward[std::size_t(i)], noise);
        up.step<integrator, axial>(flow, links, -vectorPx, -tubePx, kernel.backward[std::size_t(i)], noise);
    }
    down.count(noise);
    up.count(noise);
    return licValue(noise, own, down.lengthPx, down.width, up.lengthPx, up.width, pass.contrast);
}

template <Integrator integrator, bool axial, class Cells>
void convolveRow(const DirectPass& pass, const Cells& flow, int y, int x0, int x1)
{
    const DF d;
    const DU du;
    const LinkImage links(pass.buffer);
    const Extent& valid = pass.buffer.valid();
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        const std::ptrdiff_t start = (y - valid.y0) * std::ptrdiff_t(links.stride) + (x - valid.x0);
        const auto active = hn::Ne(hn::LoadU(du, pass.buffer.flow.origin() + start), hn::Zero(du));
        if (hn::AllFalse(du, active)) {
            hn::StoreU(hn::Zero(d), d, pass.out.row(y) + x);
            continue;
        }
        const VF value = follow<integrator, axial>(pass, flow, links, start);
        hn::StoreU(hn::IfThenElseZero(hn::RebindMask(d, active), value), d, pass.out.row(y) + x);
    }
}

template <bool axial, class Cells>
void convolveRowBy(const DirectPass& pass, const Cells& flow, int y, int x0, int x1)
{
    switch (pass.integrator) {
        case Integrator::euler:
            return convolveRow<Integrator::euler, axial>(pass, flow, y, x0, x1);
        case Integrator::rk2:
            return convolveRow<Integrator::rk2, axial>(pass, flow, y, x0, x1);
        case Integrator::rk4:
            return convolveRow<Integrator::rk4, axial>(pass, flow, y, x0, x1);
    }
}

void convolveUsualRow(const DirectPass& pass, const FlowCells& flow, int y, int x0, int x1)
{
    convolveRowBy<false>(pass, flow, y, x0, x1);
}

void convolveFineRow(const DirectPass& pass, const FineCells& flow, int y, int x0, int x1)
{
    flow.flow->axial ? convolveRowBy<true>(pass, flow, y, x0, x1) : convolveRowBy<false>(pass, flow, y, x0, x1);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(convolveUsualRow);
HWY_EXPORT(convolveFineRow);

namespace {

// Calls convolveRow(pass, y, x0, x1) for the surface's part of each row of each tile.
template <class ConvolveRow>
void convolve(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, LicImage& out,
              const ConvolveRow& convolveRow)
{
    const DirectPass pass{
        buffer, makeKernelWeights(makeKernelModel(lic)), makeContrastModel(lic), lic.integrator, lic.streaks, out};
    forEachTile(compute, 64, 16, [&](const Extent& tile) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const ColumnSpan surface = buffer.surfaceColumns(y);
            convolveRow(pass, y, std::max(tile.x0, surface.x0), std::min(tile.x1, surface.x1));
        }
    });
}

}  // namespace

void convolveDirect(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute,
                    LicImage& out)
{
    convolve(buffer, lic, compute, out, [&](const DirectPass& pass, int y, int x0, int x1) {
        HWY_DYNAMIC_DISPATCH(convolveUsualRow)(pass, flow, y, x0, x1);
    });
}

void convolveDirect(const GBuffer& buffer, const FineCells& flow, const LicOptions& lic, const Extent& compute,
                    LicImage& out)
{
    convolve(buffer, lic, compute, out, [&](const DirectPass& pass, int y, int x0, int x1) {
        HWY_DYNAMIC_DISPATCH(convolveFineRow)(pass, flow, y, x0, x1);
    });
}

}  // namespace aeolic::cpu
#endif
