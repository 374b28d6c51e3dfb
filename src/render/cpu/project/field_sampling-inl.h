// Per-target include (Highway compiles it once per target): which samples of a GridField are around a
// position, and trilinear look-ups of them.

#if defined(AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#undef AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#else
#define AEOLIC_RENDER_CPU_FIELD_SAMPLING_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "render/cpu/project/field_lookup.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A cell has four rows of two samples each: (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1).
inline constexpr int kCellRows = 4;

/// Where the samples around each lane's position are, and its weights among them.
template <class D>
struct Cell {
    WideOffsets<D> offset;  // Where samples lie in rows: the bytes before that at (x, y, z).
    // In tiles, of each row: which of the samples is at x, and which lies in memory before that at x + 1: the same, but
    // for where a column ends.
    hn::Vec<hn::RebindToUnsigned<D>> left[kCellRows], right[kCellRows];
    Vec3v<hn::Vec<D>> weight;
    hn::Mask<D> inside;
};

/// Where the corners of cells are in tiles (FieldTiles::index()). Lower corners count from the first sample held.
template <class D, class VI>
HWY_INLINE void findInTiles(D d, const FieldLookup& f, VI x, VI y, VI z, Cell<D>& cell)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    constexpr int kLayersBits = 3;
    static_assert(FieldTiles::kLayers == 1 << kLayersBits);
    const auto beforeColumn = [&](VI sample) AEOLIC_INLINE {  // In columns to the left.
        constexpr auto kWidth = float(FieldTiles::kWidth);
        const auto middle = hn::Add(hn::ConvertTo(d, sample), hn::Set(d, 0.5f));  // Far from what rounding could turn.
        return hn::ConvertTo(di, hn::Mul(hn::Floor(hn::Mul(middle, hn::Set(d, 1 / kWidth))), hn::Set(d, kWidth)));
    };
    const VI groupSamples = hn::Set(di, std::int32_t(f.groupSamples));
    for (int k = 0; k < 2; ++k) {
        const VI layer = hn::Add(z, hn::Set(di, k)), group = hn::ShiftRight<kLayersBits>(layer),
                 below = hn::ShiftLeft<kLayersBits>(group);
        const VI layers = hn::Min(hn::Set(di, 1 << kLayersBits), hn::Sub(hn::Set(di, f.held[2]), below));
        const VI row = hn::Add(hn::Mul(y, layers), hn::Sub(layer, below)),
                 rowsOfColumn = hn::Mul(layers, hn::Set(di, f.held[1])), beforeGroup = hn::Mul(group, groupSamples);
        for (int right = 0; right < 2; ++right) {
            const VI before = beforeColumn(hn::Add(x, hn::Set(di, right)));
            const VI width =
                hn::Min(hn::Set(di, std::int32_t(FieldTiles::kWidth)), hn::Sub(hn::Set(di, f.held[0]), before));
            const VI index = hn::Add(hn::Add(beforeGroup, hn::Mul(before, rowsOfColumn)),
                                     hn::Add(hn::Mul(row, width), hn::Sub(x, before)));
            auto* const samples = (right ? cell.right : cell.left) + 2 * k;
            samples[0] = hn::BitCast(du, index);
            samples[1] = hn::BitCast(du, hn::Add(index, hn::Mul(layers, width)));
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
    if (f.brick) {  // Cells of other ranks are outside. Places looked up all the same must be held here.
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
    const hn::Repartition<std::uint64_t, D> d64;
    // Two adjacent samples in one 64-bit gather: a load port moves 64 bits as fast as 32.
    const auto row = [&](std::ptrdiff_t plus) {
        const auto* from = reinterpret_cast<const std::uint64_t*>(static_cast<const std::uint8_t*>(f.samples) + plus);
        const auto lower = hn::BitCast(d, hn::GatherOffset(d64, from, cell.offset.lower)),
                   upper = hn::BitCast(d, hn::GatherOffset(d64, from, cell.offset.upper));
        return lerp(hn::ConcatEven(d, upper, lower), hn::ConcatOdd(d, upper, lower), cell.weight.x);
    };
    const auto plane = [&](std::ptrdiff_t plus) {
        return lerp(row(plus), row(plus + f.strideBytes[1]), cell.weight.y);
    };
    return lerp(plane(0), plane(f.strideBytes[2]), cell.weight.z);
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
