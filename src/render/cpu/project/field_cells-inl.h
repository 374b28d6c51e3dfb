// Per-target include (Highway compiles it once per target): which samples of a GridField are around a position.

#if defined(AEOLIC_RENDER_CPU_FIELD_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_FIELD_CELLS_INL_H
#undef AEOLIC_RENDER_CPU_FIELD_CELLS_INL_H
#else
#define AEOLIC_RENDER_CPU_FIELD_CELLS_INL_H
#endif

#include <hwy/highway.h>

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

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
