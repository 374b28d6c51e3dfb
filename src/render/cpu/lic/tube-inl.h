// Per-target include (Highway compiles it once per target): how the stream tube around a trace narrows (lic_kernel.h).

#if defined(AEOLIC_RENDER_CPU_TUBE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_TUBE_INL_H
#undef AEOLIC_RENDER_CPU_TUBE_INL_H
#else
#define AEOLIC_RENDER_CPU_TUBE_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/lic/trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The tube's width after half a step, in widths before it, at most 1. Where streamlines run the way of the vectors
/// v, the step of n . J n / |v|^2 is what it widens by, J the vectors' derivative and n normal to v. `unitPx`: of the
/// vectors, negative for a trace upstream. Between pixels of several sheets there is no derivative, and the width
/// stays.
template <class Cells = FlowCells>
HWY_INLINE VF halfNarrowing(const Block4<VU>& cell, const Taps& taps, const FlowVector& v, float unitPx)
{
    const DF d;
    const auto changes = [&](auto field, VF& right, VF& down) AEOLIC_INLINE {
        const VF v00 = field(cell.a);
        const VF upper = hn::Sub(field(cell.b), v00), left = hn::Sub(field(cell.c), v00);
        const VF both = hn::Sub(hn::Sub(field(cell.d), field(cell.c)), upper);
        right = hn::MulAdd(taps.wy, both, upper);
        down = hn::MulAdd(taps.wx, both, left);
    };
    VF xRight, xDown, yRight, yDown;
    changes([](VU t) AEOLIC_INLINE { return cellX(t); }, xRight, xDown);
    changes([](VU t) AEOLIC_INLINE { return cellY<Cells>(t); }, yRight, yDown);
    const VF unit = hn::Set(d, unitPx), x = hn::Mul(v.x, unit), y = hn::Mul(v.y, unit);
    const VF across = hn::MulAdd(y, hn::NegMulAdd(x, xDown, hn::Mul(y, xRight)),
                                 hn::Mul(x, hn::NegMulAdd(y, yRight, hn::Mul(x, yDown))));
    // e^-b is about 1 / (1 + b + b^2 / 2) for b >= 0, half of what it narrows by: never negative, never above 1.
    const VF squared = hn::Max(hn::MulAdd(x, x, hn::Mul(y, y)), hn::Set(d, 1e-12f));
    VF half =
        hn::NegMulAdd(across, hn::Set(d, 0.5f * unitPx), hn::Mul(squared, hn::Set(d, -0.5f * limits::kSteadyWidth)));
    half = hn::Max(half, hn::Zero(d));
    if (HWY_UNLIKELY(taps.anyPartial)) half = hn::IfThenZeroElse(taps.partial, half);
    const VF fourth = hn::Mul(squared, squared);
    return hn::Div(fourth, hn::MulAdd(half, hn::MulAdd(hn::Set(d, 0.5f), half, squared), fourth));
}

/// How many pixels of full weight a walk's noise varies as much as: `total` pixels, weights counted, of which each of
/// both directions `walked` so many and ended with weight `width`.
HWY_INLINE VF effectivePixels(VF total, VF own, VF down, VF downWidth, VF up, VF upWidth)
{
    const DF d;
    const VF one = hn::Set(d, 1.0f);
    const VF both = hn::MulAdd(down, hn::Add(one, downWidth), hn::Mul(up, hn::Add(one, upWidth)));
    return hn::Div(hn::Mul(total, total), hn::MulAdd(hn::Set(d, 0.5f), both, own));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
