#include "base/parallel.h"
#include "render/cpu/convolve.h"
#include "render/lic_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/convolve_direct.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/contrast-inl.h"
#include "render/cpu/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Sums {
    VF noise, lengthPx;
};

// One step of the integrator from the flow at the present position; afterwards `at` is the flow at the new one. Returns
// the step's length in the image.
template <Integrator integrator>
HWY_INLINE VF step(const FlowCells& flow, const LinkImage& links, VF unit, Traces& t, FlowSample& at)
{
    const DF d;
    const VF x = t.dx, y = t.dy, half = hn::Mul(unit, hn::Set(d, 0.5f));
    const auto sample = [&](const FlowVector& v, VF by) AEOLIC_INLINE {
        return sampleFlow(flow, links, hn::MulAdd(v.x, by, x), hn::MulAdd(v.y, by, y), t);
    };
    FlowVector v = at.vector;
    if constexpr (integrator == Integrator::rk2) {
        v = sample(v, half).vector;
    } else if constexpr (integrator == Integrator::rk4) {
        const FlowVector k2 = sample(v, half).vector, k3 = sample(k2, half).vector, k4 = sample(k3, unit).vector;
        const auto mean = [&](VF a, VF b, VF c, VF e) {
            return hn::Mul(hn::Set(d, 1.0f / 6.0f), hn::MulAdd(hn::Set(d, 2.0f), hn::Add(b, c), hn::Add(a, e)));
        };
        v = {mean(v.x, k2.x, k3.x, k4.x), mean(v.y, k2.y, k3.y, k4.y)};
    }
    at = sample(v, unit);
    return stepLength(v, hn::Abs(unit));
}

// Follows the streamlines downstream and upstream at once to the end of the kernel or of the traces, adding up weighted
// noise. One trace alone waits for its own loads; two chains in flight fill the gaps (1.7 times the speed).
template <Integrator integrator>
HWY_INLINE Sums follow(const GBuffer& buffer, const FlowCells& flow, const LinkImage& links, std::ptrdiff_t start,
                       const KernelWeights& kernel)
{
    const DF d;
    const FlowSample origin = flowAtPixel(buffer, start);
    const float vectorPx = vectorUnitPx(buffer);
    const VF own = ownLength(origin.vector, vectorPx);
    Sums sums{hn::Mul(hn::Mul(own, hn::Set(d, kernel.forward[0])), origin.noise), own};
    Traces down = startTraces(buffer, links, start);
    down.alive = hn::And(down.alive, flowsOn(origin.vector, origin.vector));
    Traces up = down;
    FlowSample atDown = origin, atUp = origin;
    const auto advance = [&](Traces& t, FlowSample& at, float unitPx, float weight) AEOLIC_INLINE {
        const FlowVector before = at.vector;
        const VF walked = step<integrator>(flow, links, hn::Set(d, unitPx), t, at);
        const VF length = hn::IfThenElseZero(t.alive, walked);
        sums.noise = hn::MulAdd(hn::Mul(length, hn::Set(d, weight)), at.noise, sums.noise);
        sums.lengthPx = hn::Add(sums.lengthPx, length);
        t.alive = hn::And(t.alive, flowsOn(before, at.vector));
    };
    for (int i = 1; i <= kernel.steps && !hn::AllFalse(d, hn::Or(down.alive, up.alive)); ++i) {
        advance(down, atDown, vectorPx, kernel.forward[std::size_t(i)]);
        advance(up, atUp, -vectorPx, kernel.backward[std::size_t(i)]);
    }
    return sums;
}

template <Integrator integrator>
void convolveRow(const GBuffer& buffer, const FlowCells& flow, const KernelWeights& kernel,
                 const ContrastModel& contrast, int y, int x0, int x1, LicImage& out)
{
    const DF d;
    const DU du;
    const LinkImage links(buffer);
    const Extent& valid = buffer.valid();
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        const std::ptrdiff_t start = (y - valid.y0) * std::ptrdiff_t(links.stride) + (x - valid.x0);
        const auto active = hn::Ne(hn::LoadU(du, buffer.flow.origin() + start), hn::Zero(du));
        if (hn::AllFalse(du, active)) {
            hn::StoreU(hn::Zero(d), d, out.row(y) + x);
            continue;
        }
        const Sums sums = follow<integrator>(buffer, flow, links, start, kernel);
        hn::StoreU(hn::IfThenElseZero(hn::RebindMask(d, active), licValue(sums.noise, sums.lengthPx, contrast)), d,
                   out.row(y) + x);
    }
}

void convolveTileRow(const GBuffer& buffer, const FlowCells& flow, Integrator integrator, const KernelWeights& kernel,
                     const ContrastModel& contrast, int y, int x0, int x1, LicImage& out)
{
    switch (integrator) {
        case Integrator::euler:
            return convolveRow<Integrator::euler>(buffer, flow, kernel, contrast, y, x0, x1, out);
        case Integrator::rk2:
            return convolveRow<Integrator::rk2>(buffer, flow, kernel, contrast, y, x0, x1, out);
        case Integrator::rk4:
            return convolveRow<Integrator::rk4>(buffer, flow, kernel, contrast, y, x0, x1, out);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(convolveTileRow);

void convolveDirect(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute,
                    LicImage& out)
{
    const KernelWeights kernel = makeKernelWeights(lic);
    const ContrastModel contrast = makeContrastModel(lic);
    forEachTile(compute, 64, 16, [&](const Extent& tile) {
        for (int y = tile.y0; y < tile.y1; ++y) HWY_DYNAMIC_DISPATCH(convolveTileRow)
        (buffer, flow, lic.integrator, kernel, contrast, y, tile.x0, tile.x1, out);
    });
}

}  // namespace aeolic::cpu
#endif
