// Per-target include (Highway compiles it once per target): trilinear look-ups of a GridField.

#if defined(AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#undef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#else
#define AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#endif

#include <hwy/highway.h>

#include <initializer_list>

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
    // In tiles, of the rows (y, z), (y + 1, z), (y, z + 1) and (y + 1, z + 1) the sample at x, and the one at x + 1
    // less a sample's bytes: in rows these would be the same.
    WideOffsets<D> left[4], right[4];
};

/// Where the corners of cells are in tiles (FieldTiles::index()). Lower corners count from the first sample held.
template <class D, class VI>
HWY_INLINE void findInTiles(D d, const FieldLookup& f, VI x, VI y, VI z, Cell<D>& cell)
{
    const hn::RebindToSigned<D> di;
    const typename WideOffsets<D>::D64 d64;
    constexpr int kLayersBits = 2;
    static_assert(FieldTiles::kLayers == 1 << kLayersBits);
    const auto sampleBytes = hn::Set(di, std::int32_t(f.strideBytes[0]));
    const auto samplesBefore = [&](VI sample) AEOLIC_INLINE {  // In columns to the left.
        constexpr auto kWidth = float(FieldTiles::kWidth);
        const auto middle = hn::Add(hn::ConvertTo(d, sample), hn::Set(d, 0.5f));  // Far from what rounding could turn.
        return hn::ConvertTo(di, hn::Mul(hn::Floor(hn::Mul(middle, hn::Set(d, 1 / kWidth))), hn::Set(d, kWidth)));
    };
    for (int k = 0; k < 2; ++k) {
        const VI layer = hn::Add(z, hn::Set(di, k)), group = hn::ShiftRight<kLayersBits>(layer),
                 above = hn::ShiftLeft<kLayersBits>(group);
        const VI layers = hn::Min(hn::Set(di, 1 << kLayersBits), hn::Sub(hn::Set(di, f.held[2]), above));
        const VI row = hn::Add(hn::Mul(y, layers), hn::Sub(layer, above)),
                 rowsOfColumn = hn::Mul(layers, hn::Set(di, f.held[1]));
        const auto groups = widen(d, group);
        const auto wide = [&](VI bytes) AEOLIC_INLINE {
            const auto inGroup = widen(d, bytes);
            const auto groupBytes = hn::Set(d64, f.groupBytes);
            return WideOffsets<D>{hn::Add(hn::Mul(groups.lower, groupBytes), inGroup.lower),
                                  hn::Add(hn::Mul(groups.upper, groupBytes), inGroup.upper)};
        };
        for (int right = 0; right < 2; ++right) {
            const VI before = samplesBefore(hn::Add(x, hn::Set(di, right)));
            const VI width =
                hn::Min(hn::Set(di, std::int32_t(FieldTiles::kWidth)), hn::Sub(hn::Set(di, f.held[0]), before));
            const VI index = hn::Add(hn::Add(hn::Mul(before, rowsOfColumn), hn::Mul(row, width)), hn::Sub(x, before));
            const VI bytes = hn::Mul(index, sampleBytes), next = hn::Mul(hn::Mul(layers, width), sampleBytes);
            WideOffsets<D>* const rows = (right ? cell.right : cell.left) + 2 * k;
            rows[0] = wide(bytes);
            rows[1] = wide(hn::Add(bytes, next));
        }
    }
}

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
    for (int c = 0; c < 3; ++c) {
        if (f.tiled) lower[c] = hn::Sub(lower[c], hn::Set(d, f.first[c]));
        index[c] = hn::ConvertTo(di, lower[c]);
    }
    Cell<D> cell;
    cell.weight = {weight[0], weight[1], weight[2]};
    cell.inside = inside;
    if (f.tiled) {
        findInTiles(d, f, index[0], index[1], index[2], cell);
        return cell;
    }
    const auto x = widen(d, index[0]), y = widen(d, index[1]), z = widen(d, index[2]);
    const auto offset = [&](auto ix, auto iy, auto iz) {
        return hn::Add(
            hn::Mul(ix, hn::Set(d64, f.strideBytes[0])),
            hn::Add(hn::Mul(iy, hn::Set(d64, f.strideBytes[1])), hn::Mul(iz, hn::Set(d64, f.strideBytes[2]))));
    };
    cell.offset = {offset(x.lower, y.lower, z.lower), offset(x.upper, y.upper, z.upper)};
    return cell;
}

/// Asks for the samples of cells whose vectors are looked up soon: of each of a cell's four rows both ends, for a third
/// of them lie in two lines. (Zen 5: with 512^3 samples projecting takes 7/10 of the time, a sixth more of it with one
/// end.)
template <class D>
HWY_INLINE void prefetchCell(D d, const FieldLookup& f, const Cell<D>& cell)
{
    const typename WideOffsets<D>::D64 d64;
    const auto* samples = static_cast<const std::uint8_t*>(f.samples);
    const auto ask = [&](const WideOffsets<D>& at, std::initializer_list<std::int64_t> plus) AEOLIC_INLINE {
        HWY_ALIGN std::int64_t offset[hn::MaxLanes(d)];
        hn::Store(at.lower, d64, offset);
        hn::Store(at.upper, d64, offset + hn::Lanes(d64));
        for (std::size_t i = 0; i < hn::Lanes(d); ++i)
            for (const std::int64_t bytes : plus) __builtin_prefetch(samples + offset[i] + bytes);
    };
    const std::int64_t end = 2 * f.strideBytes[0] - 1, y = f.strideBytes[1], z = f.strideBytes[2];
    if (f.tiled) {
        for (const WideOffsets<D>& row : cell.left) ask(row, {0});
        for (const WideOffsets<D>& row : cell.right) ask(row, {end});
    } else {
        ask(cell.offset, {0, end, y, y + end, z, z + end, y + z, y + z + end});
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
/// halves, two where they may lie apart.
template <bool kTiled, class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleRow(D d, const FieldLookup& f, const WideOffsets<D>& leftAt,
                                       const WideOffsets<D>& rightAt, std::ptrdiff_t plus, hn::Vec<D> t)
{
    const hn::RebindToUnsigned<D> du;
    if (f.half) {
        const auto low = [&](auto v) { return floatFromHalf(d, hn::And(v, hn::Set(du, 0xFFFFu))); };
        const auto high = [&](auto v) { return floatFromHalf(d, hn::ShiftRight<16>(v)); };
        const auto left = loadBlocksWide(du, f.samples, leftAt, plus);  // x0 y0 | z0 x1 | y1 z1
        auto right = left;
        if constexpr (kTiled) right = loadBlocksWide(du, f.samples, rightAt, plus);
        return {lerp(low(left.a), high(right.b), t), lerp(high(left.a), low(right.c), t),
                lerp(low(left.b), high(right.c), t)};
    }
    const auto left = loadBlocksWide(d, f.samples, leftAt, plus);        // x0 y0 z0 x1
    const auto right = loadBlocksWide(d, f.samples, rightAt, plus + 8);  // z0 x1 y1 z1
    return {lerp(left.a, right.b, t), lerp(left.b, right.c, t), lerp(left.c, right.d, t)};
}

/// Trilinear vector at local positions; NaN where masked, unspecified outside `cell.inside`.
template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> sampleVector(D d, const FieldLookup& f, const Cell<D>& cell)
{
    using V3d = Vec3v<hn::Vec<D>>;
    const auto blend = [](const V3d& a, const V3d& b, auto t) {
        return V3d{lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)};
    };
    const auto ty = cell.weight.y, tz = cell.weight.z;
    if (f.tiled) {
        const auto row = [&](int k) AEOLIC_INLINE {
            return sampleRow<true>(d, f, cell.left[k], cell.right[k], 0, cell.weight.x);
        };
        return blend(blend(row(0), row(1), ty), blend(row(2), row(3), ty), tz);
    }
    const auto row = [&](std::ptrdiff_t plus) AEOLIC_INLINE {
        return sampleRow<false>(d, f, cell.offset, cell.offset, plus, cell.weight.x);
    };
    const std::int64_t y = f.strideBytes[1], z = f.strideBytes[2];
    return blend(blend(row(0), row(y), ty), blend(row(z), row(y + z), ty), tz);
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
