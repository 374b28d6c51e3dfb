// Per-target include (Highway compiles it once per target): trilinear look-ups of a GridField.

#if defined(AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#undef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#else
#define AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/field_lookup.h"
#include "render/cpu/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The lower corner of each lane's cell, its weights, and where its samples start.
template <class D>
struct Cell {
    WideOffsets<D> offset;
    Vec3v<hn::Vec<D>> weight;
    hn::Mask<D> inside;
};

template <class D>
HWY_INLINE Cell<D> findCell(D d, const FieldLookup& f, const Vec3v<hn::Vec<D>>& local, hn::Mask<D> active)
{
    using V = hn::Vec<D>;
    const hn::RebindToSigned<D> di;
    const typename WideOffsets<D>::D64 d64;
    auto inside = active;
    V lower[3], weight[3];
    const V coordinate[3] = {local.x, local.y, local.z};
    for (int c = 0; c < 3; ++c) {
        const V g = hn::MulAdd(coordinate[c], hn::Set(d, f.scale[c]), hn::Set(d, f.offset[c]));
        // A surface that ends exactly where the field ends must not lose its rim to rounding.
        const V slack = hn::Set(d, 1e-3f), top = hn::Set(d, f.top[c]);
        inside = hn::And(inside, hn::And(hn::Ge(g, hn::Neg(slack)), hn::Le(g, hn::Add(top, slack))));
        const V in = hn::IfThenElseZero(inside, hn::Min(hn::Max(g, hn::Zero(d)), top));
        lower[c] = hn::Min(hn::Floor(in), hn::Sub(top, hn::Set(d, 1.0f)));
        weight[c] = hn::Sub(in, lower[c]);
    }
    if (f.brick) {  // Cells of other ranks are outside; what is looked up there all the same must be held here.
        for (int c = 0; c < 3; ++c)
            inside = hn::And(
                inside, hn::And(hn::Ge(lower[c], hn::Set(d, f.cellLo[c])), hn::Lt(lower[c], hn::Set(d, f.cellHi[c]))));
        for (int c = 0; c < 3; ++c) lower[c] = hn::IfThenElse(inside, lower[c], hn::Set(d, f.cellLo[c]));
    }
    hn::Vec<decltype(di)> index[3];
    for (int c = 0; c < 3; ++c) index[c] = hn::ConvertTo(di, lower[c]);
    const auto x = widen(d, index[0]), y = widen(d, index[1]), z = widen(d, index[2]);
    const auto offset = [&](auto ix, auto iy, auto iz) {
        return hn::Add(
            hn::Mul(ix, hn::Set(d64, f.strideBytes[0])),
            hn::Add(hn::Mul(iy, hn::Set(d64, f.strideBytes[1])), hn::Mul(iz, hn::Set(d64, f.strideBytes[2]))));
    };
    return {{offset(x.lower, y.lower, z.lower), offset(x.upper, y.upper, z.upper)},
            {weight[0], weight[1], weight[2]},
            inside};
}

/// Asks for the samples of cells whose vectors are looked up soon: of each of a cell's four rows both ends, for a third
/// of them lie in two lines. (Zen 5: with 512^3 samples projecting takes 7/10 of the time, a sixth more of it with one
/// end.)
template <class D>
HWY_INLINE void prefetchCell(D d, const FieldLookup& f, const Cell<D>& cell)
{
    const typename WideOffsets<D>::D64 d64;
    HWY_ALIGN std::int64_t offset[hn::MaxLanes(d)];
    hn::Store(cell.offset.lower, d64, offset);
    hn::Store(cell.offset.upper, d64, offset + hn::Lanes(d64));
    const auto* samples = static_cast<const std::uint8_t*>(f.samples);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i)
        for (const std::int64_t plus :
             {std::int64_t(0), f.strideBytes[1], f.strideBytes[2], f.strideBytes[1] + f.strideBytes[2]}) {
            const auto* row = samples + offset[i] + plus;
            __builtin_prefetch(row);
            __builtin_prefetch(row + 2 * f.strideBytes[0] - 1);
        }
}

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

/// Two x-adjacent vectors of one grid row, interpolated at `t`. Two 128-bit loads bring six floats, one brings six
/// halves.
template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleRow(D d, const FieldLookup& f, const Cell<D>& cell, std::ptrdiff_t plus)
{
    const hn::RebindToUnsigned<D> du;
    const auto t = cell.weight.x;
    if (f.half) {
        const auto low = [&](auto v) { return floatFromHalf(d, hn::And(v, hn::Set(du, 0xFFFFu))); };
        const auto high = [&](auto v) { return floatFromHalf(d, hn::ShiftRight<16>(v)); };
        const auto row = loadBlocksWide(du, f.samples, cell.offset, plus);  // x0 y0 | z0 x1 | y1 z1
        return {lerp(low(row.a), high(row.b), t), lerp(high(row.a), low(row.c), t), lerp(low(row.b), high(row.c), t)};
    }
    const auto left = loadBlocksWide(d, f.samples, cell.offset, plus);       // x0 y0 z0 x1
    const auto right = loadBlocksWide(d, f.samples, cell.offset, plus + 8);  // z0 x1 y1 z1
    return {lerp(left.a, right.b, t), lerp(left.b, right.c, t), lerp(left.c, right.d, t)};
}

/// Trilinear vector at local positions; NaN where masked, unspecified outside `cell.inside`.
template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleVector(D d, const FieldLookup& f, const Cell<D>& cell)
{
    const auto blend = [](const auto& a, const auto& b, auto t) {
        return Vec3v<hn::Vec<D>>{lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)};
    };
    const auto plane = [&](std::ptrdiff_t plus) AEOLIC_INLINE {
        return blend(sampleRow(d, f, cell, plus), sampleRow(d, f, cell, plus + f.strideBytes[1]), cell.weight.y);
    };
    return blend(plane(0), plane(f.strideBytes[2]), cell.weight.z);
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
