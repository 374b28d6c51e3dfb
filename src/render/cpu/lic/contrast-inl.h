// Per-target include (Highway compiles it once per target): from a trace's sums to the LIC value.

#if defined(AEOLIC_RENDER_CPU_CONTRAST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_CONTRAST_INL_H
#undef AEOLIC_RENDER_CPU_CONTRAST_INL_H
#else
#define AEOLIC_RENDER_CPU_CONTRAST_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/lic/trace-inl.h"
#include "render/lic/lic_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sine and cosine of pi x, x within [0, 1]: polynomials about the middle, within 3e-5.
HWY_INLINE void sinCosPi(VF x, VF& sine, VF& cosine)
{
    const DF d;
    const VF angle = hn::Mul(hn::Sub(x, hn::Set(d, 0.5f)), hn::Set(d, 3.14159265f)), z = hn::Mul(angle, angle);
    const auto polynomial = [&](float a, float b, float c, float e) AEOLIC_INLINE {
        VF sum = hn::MulAdd(hn::Set(d, e), z, hn::Set(d, c));
        sum = hn::MulAdd(sum, z, hn::Set(d, b));
        sum = hn::MulAdd(sum, z, hn::Set(d, a));
        return hn::MulAdd(sum, z, hn::Set(d, 1.0f));
    };
    sine = polynomial(-1.0f / 2, 1.0f / 24, -1.0f / 720, 1.0f / 40320);
    cosine = hn::Neg(hn::Mul(angle, polynomial(-1.0f / 6, 1.0f / 120, -1.0f / 5040, 1.0f / 362880)));
}

/// What brings a Hann kernel of that phase back to the contrast of phase 0 (ContrastModel), from the pixel's own length
/// and those walked.
HWY_INLINE VF phaseGain(VF own, VF down, VF up, const ContrastModel& contrast)
{
    const DF d;
    const VF one = hn::Set(d, 1.0f), scale = hn::Div(hn::Set(d, contrast.perStep), own),
             half = hn::Mul(own, hn::Set(d, 0.5f));
    const VF ahead = hn::Min(hn::Mul(hn::Add(down, half), scale), one),
             behind = hn::Min(hn::Mul(hn::Add(up, half), scale), one);
    VF sineAhead, cosineAhead, sineBehind, cosineBehind;
    sinCosPi(ahead, sineAhead, cosineAhead);
    sinCosPi(behind, sineBehind, cosineBehind);
    const auto doubled = [&](VF sine, VF cosine)
                             AEOLIC_INLINE { return hn::Mul(hn::Set(d, 2.0f), hn::Mul(sine, cosine)); };
    const auto squared = [&](VF sine)
                             AEOLIC_INLINE { return hn::NegMulAdd(hn::Mul(hn::Set(d, 2.0f), sine), sine, one); };
    const VF sines = hn::Add(sineAhead, sineBehind), cosines = hn::Sub(cosineAhead, cosineBehind);
    const VF sines2 = hn::Add(doubled(sineAhead, cosineAhead), doubled(sineBehind, cosineBehind));
    const VF cosines2 = hn::Sub(squared(sineAhead), squared(sineBehind));
    const VF whole = hn::Mul(hn::Set(d, 1.5f), hn::Add(ahead, behind));
    const auto weightOf = [&](float cosine, float sine) AEOLIC_INLINE {
        constexpr float first = 0.636619772f, second = 0.0795774715f;  // 2 / pi and 1 / (4 pi).
        const VF once = hn::NegMulAdd(hn::Set(d, sine), cosines, hn::Mul(hn::Set(d, cosine), sines));
        const float cosine2 = 1 - 2 * sine * sine, sine2 = 2 * sine * cosine;
        const VF twice = hn::NegMulAdd(hn::Set(d, sine2), cosines2, hn::Mul(hn::Set(d, cosine2), sines2));
        return hn::MulAdd(hn::Set(d, second), twice, hn::MulAdd(hn::Set(d, first), once, whole));
    };
    constexpr float most = kMostPhaseGain * kMostPhaseGain;
    const VF atRest = weightOf(1, 0), now = weightOf(contrast.phaseCosine, contrast.phaseSine);
    return hn::Sqrt(hn::Div(atRest, hn::Max(now, hn::Mul(atRest, hn::Set(d, 1 / most)))));
}

/// The LIC value of what traces gathered. `sum`: of weighted noise, bytes times pixels. `own`: the pixel's own length.
/// `down`, `up`: how many pixels were walked that way, weights counted; `downWidth`, `upWidth`: the stream tube's at
/// the end.
HWY_INLINE VF licValue(VF sum, VF own, VF down, VF downWidth, VF up, VF upWidth, const ContrastModel& contrast)
{
    const DF d;
    const VF one = hn::Set(d, 1.0f), length = hn::Add(own, hn::Add(down, up));
    // The effective length: the sum of so many pixels of full weight varies as much as this weighted sum.
    const VF both = hn::MulAdd(down, hn::Add(one, downWidth), hn::Mul(up, hn::Add(one, upWidth)));
    const VF effective = hn::Div(hn::Mul(length, length), hn::MulAdd(hn::Set(d, 0.5f), both, own));
    const VF power =
        hn::MulAdd(hn::Mul(effective, effective), hn::Set(d, contrast.perLength), hn::Set(d, contrast.zeroLength));
    const VF gain = hn::Sqrt(hn::Sqrt(power));
    const VF value =
        hn::Mul(hn::Div(sum, length), hn::Mul(gain, hn::Set(d, flow_texel::kNoiseUnit * contrast.inverseMeanWeight)));
    return contrast.phased() ? hn::Mul(value, phaseGain(own, down, up, contrast)) : value;
}

/// The length in the image of a step, in pixels; `unitPx` pixels per unit of `v`.
HWY_INLINE VF stepLength(const FlowVector& v, VF unitPx)
{
    return hn::Mul(hn::Sqrt(hn::MulAdd(v.x, v.x, hn::Mul(v.y, v.y))), unitPx);
}

/// The length of the starting pixel's own sample, pixels.
HWY_INLINE VF ownLength(const FlowVector& origin, float unitPx)
{
    return hn::Max(stepLength(origin, hn::Set(DF(), unitPx)), hn::Set(DF(), kShortestOwnPx));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
