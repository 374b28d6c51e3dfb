// Per-target include (Highway compiles it once per target): whether two places of the image show one sheet of the
// surface.

#if defined(AEOLIC_RENDER_CPU_ONE_SHEET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_ONE_SHEET_INL_H
#undef AEOLIC_RENDER_CPU_ONE_SHEET_INL_H
#else
#define AEOLIC_RENDER_CPU_ONE_SHEET_INL_H
#endif

#include <hwy/highway.h>

#include "render/limits.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How well the facets at two places a and b of the image predict each other's 1/depth.
template <class V>
struct Prediction {
    V errorA, errorB;  ///< Of the facet at a, and of that at b.
    V slack;           ///< What is no error yet.
};

/// The slack for a pixel's footprint, per unit of the sum of both 1/depths.
template <class D>
HWY_INLINE hn::Vec<D> slackPerDepth(D d, float focalPx)
{
    return hn::Set(d, 0.5f * limits::kSlackFootprints / focalPx);
}

/// `za`, `zb`: 1/depth there. `ga`, `gb`: the change from a to b on the facet at a, and on that at b.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Prediction<V> predict(D d, V za, V ga, V zb, V gb, V perDepth)
{
    const V change = hn::Sub(zb, za), steeper = hn::Max(hn::Abs(ga), hn::Abs(gb));
    const V slack = hn::MulAdd(hn::Add(za, zb), perDepth, hn::Mul(steeper, hn::Set(d, limits::kSlackSlope)));
    return {hn::Sub(change, ga), hn::Sub(gb, change), slack};
}

/// One of the predictions holds, or the facets' planes meet between the places: a crease.
template <class D, class V>
HWY_INLINE hn::Mask<D> onOneSheet(D d, const Prediction<V>& p)
{
    const auto predicted = hn::Le(hn::Min(hn::Abs(p.errorA), hn::Abs(p.errorB)), p.slack);
    return hn::Or(predicted, hn::Ge(hn::Mul(p.errorA, p.errorB), hn::Zero(d)));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
