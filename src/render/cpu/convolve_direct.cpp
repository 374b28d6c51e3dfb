#include "base/parallel.h"
#include "render/cpu/convolve.h"
#include "render/lic_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/convolve_direct.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Sums {
    VF noise, weight, count;
};

// One step of the integrator from the flow at the present position; afterwards `at` is the flow at the new one.
template <Integrator integrator>
HWY_INLINE void step(const FlowCells& flow, const LinkImage& links, VF unit, Traces& t, FlowSample& at)
{
    const DF d;
    const VF x = t.dx, y = t.dy, half = hn::Mul(unit, hn::Set(d, 0.5f));
    VF vx = at.vx, vy = at.vy;
    if constexpr (integrator == Integrator::rk2) {
        const FlowSample middle = sampleFlow(flow, links, hn::MulAdd(vx, half, x), hn::MulAdd(vy, half, y), t);
        vx = middle.vx;
        vy = middle.vy;
    } else if constexpr (integrator == Integrator::rk4) {
        const FlowSample k2 = sampleFlow(flow, links, hn::MulAdd(at.vx, half, x), hn::MulAdd(at.vy, half, y), t);
        const FlowSample k3 = sampleFlow(flow, links, hn::MulAdd(k2.vx, half, x), hn::MulAdd(k2.vy, half, y), t);
        const FlowSample k4 = sampleFlow(flow, links, hn::MulAdd(k3.vx, unit, x), hn::MulAdd(k3.vy, unit, y), t);
        const VF two = hn::Set(d, 2.0f), sixth = hn::Set(d, 1.0f / 6.0f);
        vx = hn::Mul(sixth, hn::MulAdd(two, hn::Add(k2.vx, k3.vx), hn::Add(at.vx, k4.vx)));
        vy = hn::Mul(sixth, hn::MulAdd(two, hn::Add(k2.vy, k3.vy), hn::Add(at.vy, k4.vy)));
    }
    at = sampleFlow(flow, links, hn::MulAdd(vx, unit, x), hn::MulAdd(vy, unit, y), t);
}

// Follows one direction to the end of the kernel or of the trace, adding up weighted noise.
template <Integrator integrator>
HWY_INLINE void follow(const GBuffer& buffer, const FlowCells& flow, const LinkImage& links, std::ptrdiff_t start, float unitPx, const float* weights, int steps, Sums& sums)
{
    const DF d;
    const VF unit = hn::Set(d, unitPx), one = hn::Set(d, 1.0f);
    Traces t = startTraces(buffer, start);
    FlowSample at = flowAtPixel(buffer, start);
    const VF vanishing = hn::Set(d, 2.0f);  // Squared flow units: below that a vector is only its rounding.
    for (int i = 1; i <= steps; ++i) {
        t.alive = hn::And(t.alive, hn::Gt(hn::MulAdd(at.vx, at.vx, hn::Mul(at.vy, at.vy)), vanishing));
        if (hn::AllFalse(d, t.alive)) return;
        step<integrator>(flow, links, unit, t, at);
        const VF weight = hn::IfThenElseZero(t.alive, hn::Set(d, weights[i]));
        sums.noise = hn::MulAdd(weight, at.noise, sums.noise);
        sums.weight = hn::Add(sums.weight, weight);
        sums.count = hn::Add(sums.count, hn::IfThenElseZero(t.alive, one));
    }
}

// Mean noise to unit variance: see ContrastModel. The walked length in pixels is the steps times the pixel's own step.
HWY_INLINE VF normalised(const Sums& sums, const FlowSample& origin, float unitPx, const ContrastModel& contrast)
{
    const DF d;
    const VF speed = hn::Mul(hn::Sqrt(hn::MulAdd(origin.vx, origin.vx, hn::Mul(origin.vy, origin.vy))), hn::Set(d, unitPx));
    const VF gain = hn::Sqrt(hn::MulAdd(hn::Mul(sums.count, speed), hn::Set(d, contrast.inverseCorrelationPx), hn::Set(d, 1.0f)));
    const VF tiny = hn::Set(d, 1e-6f);
    const VF mean = hn::Div(hn::Mul(sums.noise, hn::Set(d, flow_texel::kNoiseUnit)), hn::Max(sums.weight, tiny));
    return hn::Mul(mean, hn::Mul(gain, hn::Set(d, contrast.inverseSigma)));
}

template <Integrator integrator>
void convolveRow(const GBuffer& buffer, const FlowCells& flow, const KernelWeights& kernel, const ContrastModel& contrast, int y, int x0, int x1, LicImage& out)
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
        const FlowSample origin = flowAtPixel(buffer, start);
        const VF first = hn::Set(d, kernel.forward[0]);
        Sums sums{hn::Mul(first, origin.noise), first, hn::Zero(d)};
        follow<integrator>(buffer, flow, links, start, buffer.flowUnitPx, kernel.forward.data(), kernel.steps, sums);
        follow<integrator>(buffer, flow, links, start, -buffer.flowUnitPx, kernel.backward.data(), kernel.steps, sums);
        hn::StoreU(hn::IfThenElseZero(hn::RebindMask(d, active), normalised(sums, origin, buffer.flowUnitPx, contrast)), d, out.row(y) + x);
    }
}

void convolveTileRow(const GBuffer& buffer, const FlowCells& flow, Integrator integrator, const KernelWeights& kernel, const ContrastModel& contrast, int y, int x0,
                     int x1, LicImage& out)
{
    switch (integrator) {
        case Integrator::euler: return convolveRow<Integrator::euler>(buffer, flow, kernel, contrast, y, x0, x1, out);
        case Integrator::rk2: return convolveRow<Integrator::rk2>(buffer, flow, kernel, contrast, y, x0, x1, out);
        case Integrator::rk4: return convolveRow<Integrator::rk4>(buffer, flow, kernel, contrast, y, x0, x1, out);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(convolveTileRow);

void convolveDirect(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute, LicImage& out)
{
    const KernelWeights kernel = makeKernelWeights(lic);
    const ContrastModel contrast = makeContrastModel(lic);
    forEachTile(compute, 64, 16, [&](const Extent& tile) {
        for (int y = tile.y0; y < tile.y1; ++y)
            HWY_DYNAMIC_DISPATCH(convolveTileRow)(buffer, flow, lic.integrator, kernel, contrast, y, tile.x0, tile.x1, out);
    });
}

}  // namespace aeolic::cpu
#endif
