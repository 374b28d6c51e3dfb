// Per-target include (Highway compiles it once per target): trilinear look-ups of a GridField.

#if defined(AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#undef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#else
#define AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "render/cpu/project/field_cells-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// IEEE half in the low 16 bits of each lane to float; NaN stays NaN, which is the mask.
template <class D, class VU>
HWY_INLINE hn::Vec<D> floatFromHalf(D d, VU bits)
{
    const hn::RebindToUnsigned<D> du;
    const auto magnitude = hn::And(bits, hn::Set(du, 0x7FFFu));
    const auto sign = hn::ShiftLeft<16>(hn::And(bits, hn::Set(du, 0x8000u)));
    const auto scaled =
        hn::Mul(hn::BitCast(d, hn::ShiftLeft<13>(magnitude)), hn::Set(d, 0x1p112f));  // Exact, subnormals too.
    const auto value = hn::IfThenElse(hn::RebindMask(d, hn::Gt(magnitude, hn::Set(du, 0x7BFFu))), hn::NaN(d), scaled);
    return hn::Or(value, hn::BitCast(d, sign));
}

/// The vectors at x and x + 1 of a row of lanes' cells, interpolated at `t`, from halves: x0 y0 | z0 x1 | y1 z1, of
/// which the first three words are `left`'s and the last three `right`'s.
template <class D, class VU>
HWY_INLINE Vec3v<hn::Vec<D>> lerpHalves(D d, const Block4<VU>& left, const Block4<VU>& right, hn::Vec<D> t)
{
    const hn::RebindToUnsigned<D> du;
    const auto low = [&](auto v) { return floatFromHalf(d, hn::And(v, hn::Set(du, 0xFFFFu))); };
    const auto high = [&](auto v) { return floatFromHalf(d, hn::ShiftRight<16>(v)); };
    return {lerp(low(left.a), high(right.b), t), lerp(high(left.a), low(right.c), t),
            lerp(low(left.b), high(right.c), t)};
}

/// Interpolates such a row from floats: x0 y0 z0 x1 and z0 x1 y1 z1.
template <class V>
HWY_INLINE Vec3v<V> lerpFloats(const Block4<V>& left, const Block4<V>& right, V t)
{
    return {lerp(left.a, right.b, t), lerp(left.b, right.c, t), lerp(left.c, right.d, t)};
}

/// A row of samples that lie in rows, `plus` bytes after the cells' first.
template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleRow(D d, const FieldLookup& f, const Cell<D>& cell, std::ptrdiff_t plus)
{
    const hn::RebindToUnsigned<D> du;
    if (f.half) {
        const auto both = loadBlocksWide(du, f.samples, cell.offset, plus);
        return lerpHalves(d, both, both, cell.weight.x);
    }
    return lerpFloats(loadBlocksWide(d, f.samples, cell.offset, plus),
                      loadBlocksWide(d, f.samples, cell.offset, plus + 8), cell.weight.x);
}

/// Row `k` of kCellRows, of samples that lie in tiles.
template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleTiledRow(D d, const FieldLookup& f, const Cell<D>& cell, int k)
{
    const hn::RebindToUnsigned<D> du;
    if (f.half) {
        const auto* halves = static_cast<const std::uint16_t*>(f.samples);
        return lerpHalves(d, loadBlocks<3>(du, halves, cell.left[k]), loadBlocks<3>(du, halves, cell.right[k]),
                          cell.weight.x);
    }
    const auto* floats = static_cast<const float*>(f.samples);
    return lerpFloats(loadBlocks<3>(d, floats, cell.left[k]), loadBlocks<3>(d, floats + 2, cell.right[k]),
                      cell.weight.x);
}

/// Trilinear vector at local positions; NaN where masked, unspecified outside `cell.inside`.
template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleVector(D d, const FieldLookup& f, const Cell<D>& cell)
{
    using V3d = Vec3v<hn::Vec<D>>;
    const auto blend = [](const V3d& a, const V3d& b, auto t) {
        return V3d{lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)};
    };
    const auto blendRows = [&](const auto& row) AEOLIC_INLINE {
        return blend(blend(row(0), row(1), cell.weight.y), blend(row(2), row(3), cell.weight.y), cell.weight.z);
    };
    if (f.tiled) return blendRows([&](int k) AEOLIC_INLINE { return sampleTiledRow(d, f, cell, k); });
    const std::int64_t y = f.strideBytes[1], z = f.strideBytes[2];
    return blendRows([&](int k) AEOLIC_INLINE { return sampleRow(d, f, cell, (k & 1) * y + (k >> 1) * z); });
}

/// Trilinear scalar (float storage) at local positions.
template <class D>
HWY_INLINE hn::Vec<D> sampleScalar(D d, const FieldLookup& f, const Cell<D>& cell)
{
    const hn::RebindToUnsigned<D> du;
    const auto row = [&](std::ptrdiff_t plus) {
        const auto pair = gatherWords(du, f.samples, cell.offset, plus);
        return lerp(hn::BitCast(d, pair.first), hn::BitCast(d, pair.second), cell.weight.x);
    };
    const auto plane = [&](std::ptrdiff_t plus) {
        return lerp(row(plus), row(plus + f.strideBytes[1]), cell.weight.y);
    };
    return lerp(plane(0), plane(f.strideBytes[2]), cell.weight.z);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
