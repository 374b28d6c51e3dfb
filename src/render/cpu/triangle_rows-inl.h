// Per-target include (Highway compiles it once per target): drawing a triangle's rows of pixels.

#if defined(AEOLIC_RENDER_CPU_TRIANGLE_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_TRIANGLE_ROWS_INL_H
#undef AEOLIC_RENDER_CPU_TRIANGLE_ROWS_INL_H
#else
#define AEOLIC_RENDER_CPU_TRIANGLE_ROWS_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/raster.h"
#include "render/cpu/triangle_rows.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A vector of pixels at a time. Edge values below 2^53 are exact as doubles, and what is exact does not depend on the
/// way.
HWY_INLINE void drawRows(TriangleRows t, const Extent& tile, TileKeys& keys)
{
    const hn::ScalableTag<double> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::Rebind<float, decltype(d)> df;
    const hn::Rebind<std::uint32_t, decltype(d)> du32;
    const auto zero = hn::Zero(d), lane = hn::Iota(d, 0);
    const auto notId = hn::Set(du, std::uint64_t(t.notId));
    const auto lowest = hn::Set(df, t.lowest), highest = hn::Set(df, t.highest), farthest = hn::Set(df, t.farthest);
    const auto rise = [&](std::int64_t perPixel) { return hn::Mul(lane, hn::Set(d, double(perPixel))); };
    const auto e0 = rise(t.edgeX[0]), e1 = rise(t.edgeX[1]), e2 = rise(t.edgeX[2]);
    for (int y = t.y0; y < t.y1; ++y) {
        std::uint64_t* row = keys.key[y - tile.y0] - tile.x0;
        const double rowDepth = t.rowDepth();
        for (int x = t.x0; x < t.x1; x += int(hn::Lanes(d))) {
            const auto start = [&](int k) { return hn::Set(d, double(t.edge[k] + (x - t.x0) * t.edgeX[k])); };
            const auto smallest = hn::Min(hn::Min(hn::Add(e0, start(0)), hn::Add(e1, start(1))), hn::Add(e2, start(2)));
            const auto column = hn::Add(lane, hn::Set(d, double(x - t.x0)));
            const auto inside = hn::And(hn::Ge(smallest, zero), hn::Lt(column, hn::Set(d, double(t.x1 - t.x0))));
            if (hn::AllFalse(d, inside)) continue;
            const auto fromA = hn::Add(hn::Mul(lane, hn::Set(d, double(kSubpixels))),
                                       hn::Set(d, double(t.fromAX + (x - t.x0) * kSubpixels)));
            const auto plane = hn::Add(hn::Mul(fromA, hn::Set(d, t.depthX)), hn::Set(d, rowDepth));
            const auto depth = hn::Min(hn::Max(hn::DemoteTo(df, plane), lowest), highest);
            const auto key = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(du, hn::BitCast(du32, depth))), notId);
            const auto near = hn::PromoteTo(d, hn::IfThenElseZero(hn::Ge(depth, farthest), hn::Set(df, 1.0f)));
            const auto before = hn::LoadU(du, row + x);
            const auto nearer = hn::And(hn::Gt(key, before), hn::RebindMask(du, hn::And(inside, hn::Gt(near, zero))));
            hn::StoreU(hn::IfThenElse(nearer, key, before), du, row + x);
        }
        t.nextRow();
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
