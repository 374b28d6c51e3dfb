#include "render/cpu/edges/edge_samples.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/edges/edge_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/surface_hit-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Samples from `at` on, of which pixels lie at `x` and `y`: a place between pixels is found as their centres are.
HWY_INLINE void resolveSome(std::size_t at, const float* x, const float* y, const SceneArrays& arrays, const View& view,
                            EdgeSamples& samples)
{
    const DF d;
    const DI di;
    const DU du;
    hn::Vec<DU> complement, depthBits;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(&samples.keys[at]), complement, depthBits);
    const auto hasKey = hn::Ne(depthBits, hn::Zero(du));
    if (hn::AllFalse(du, hasKey)) {
        hn::StoreU(hn::Zero(d), d, &samples.invDepth[at]);
        return;
    }
    const VF inverseFocal = hn::Set(d, 1.0f / view.focalPx);
    const VF xs = hn::Mul(hn::Sub(hn::LoadU(d, x), hn::Set(d, view.centerX)), inverseFocal),
             ys = hn::Mul(hn::Sub(hn::LoadU(d, y), hn::Set(d, view.centerY)), inverseFocal);
    const VI triangle = hn::BitCast(di, hn::IfThenElseZero(hasKey, hn::Not(complement)));
    const Hit hit = intersect(triangle, hn::RebindMask(d, hasKey), xs, ys, arrays, view);
    const VF depth = hn::Max(dot(hit.fromEye, broadcast(d, view.forward)), hn::Set(d, float(view.nearDepth)));
    const Vec3v<VF> normal = shadingNormal(hit);
    const DepthGradient gradient = depthGradient(hit, view);
    const VF invDepth = hn::IfThenElseZero(hit.covered, hn::Div(hn::Set(d, 1.0f), depth));
    hn::StoreU(invDepth, d, &samples.invDepth[at]);
    hn::StoreU(gradient.x, d, &samples.gradX[at]);
    hn::StoreU(gradient.y, d, &samples.gradY[at]);
    hn::StoreU(lightOn(normal, facingOf(normal, hit), broadcast(d, view.softLight)), d, &samples.light[at]);
}

void resolveAll(const EdgePixels& pixels, const SceneArrays& arrays, const View& view, EdgeSamples& samples)
{
    static_assert(hn::MaxLanes(DF()) <= EdgeSamples::kPadding);
    const std::size_t lanes = hn::Lanes(DF());
    constexpr std::size_t kMost = std::max<std::size_t>(hn::MaxLanes(DF()), antialias::kSamples);
    float x[kMost + antialias::kSamples], y[kMost + antialias::kSamples];
    std::size_t held = 0, done = 0;
    const auto resolveHeld = [&]() HWY_ATTR {
        for (std::size_t i = 0; i < held; i += lanes) resolveSome(done + i, x + i, y + i, arrays, view, samples);
        done += held;
        held = 0;
    };
    pixels.forEach([&](std::uint32_t, int px, int py) {
        for (int s = 0; s < antialias::kSamples; ++s) {
            const auto place = [&](int pixel, std::int32_t parts) {
                return float(pixel) + 0.5f + float(parts) / float(antialias::kParts);
            };
            x[held] = place(px, antialias::kRight[s]);
            y[held] = place(py, antialias::kDown[s]);
            ++held;
        }
        if (held >= lanes) resolveHeld();
    });
    if (held > 0) {
        std::fill(x + held, x + kMost, x[0]);
        std::fill(y + held, y + kMost, y[0]);
        resolveHeld();
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(resolveAll);

void EdgeSamples::clear(std::size_t pixels)
{
    const std::size_t padded = pixels * antialias::kSamples + kPadding;
    keys.assign(padded, 0);
    for (std::vector<float>* values : {&invDepth, &gradX, &gradY, &light}) values->resize(padded);
}

void resolveSamples(const EdgePixels& pixels, const SceneArrays& arrays, const View& view, EdgeSamples& samples)
{
    HWY_DYNAMIC_DISPATCH(resolveAll)(pixels, arrays, view, samples);
}

}  // namespace aeolic::cpu
#endif
