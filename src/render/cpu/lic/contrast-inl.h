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

/// A trace's weighted sum (noise bytes times pixels), weighted length, and how many pixels of full weight vary as much,
/// to the LIC value.
HWY_INLINE VF licValue(VF sum, VF lengthPx, VF effectivePx, const ContrastModel& contrast)
{
    const DF d;
    const VF power =
        hn::MulAdd(hn::Mul(effectivePx, effectivePx), hn::Set(d, contrast.perLength), hn::Set(d, contrast.zeroLength));
    const VF gain = hn::Sqrt(hn::Sqrt(power));
    return hn::Mul(hn::Div(sum, lengthPx),
                   hn::Mul(gain, hn::Set(d, flow_texel::kNoiseUnit * contrast.inverseMeanWeight)));
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
