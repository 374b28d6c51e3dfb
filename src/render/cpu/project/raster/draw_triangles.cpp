#include "render/cpu/project/raster/draw_triangles.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "render/cpu/project/raster/triangle_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/raster/draw_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/project/raster/triangle_batch-inl.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// One of a batch: a column of vectors after the other, downwards. The same keys as drawTriangle(), whose edge functions
// need more bits.
HWY_INLINE void drawSmall(const Batch& batch, std::size_t lane, const Extent& tile, std::uint64_t farKey,
                          TileKeys& keys)
{
    const hn::ScalableTag<double> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::RebindToSigned<decltype(d)> di;
    const hn::Rebind<float, decltype(d)> df;
    const hn::Rebind<std::int32_t, decltype(d)> di32;
    const hn::Rebind<std::uint32_t, decltype(d)> du32;
    const int x0 = batch.x0[lane], x1 = batch.x1[lane], y0 = batch.y0[lane], y1 = batch.y1[lane];
    const auto notId = hn::Set(du, std::uint64_t(~batch.id[lane])), farthest = hn::Set(du, farKey);
    const auto lowest = hn::Set(df, batch.lowest[lane]), highest = hn::Set(df, batch.highest[lane]),
               bias = hn::Set(df, batch.bias[lane]);
    const auto depth = hn::Set(d, double(batch.depth[lane])), depthX = hn::Set(d, batch.depthX[lane]),
               depthY = hn::Set(d, batch.depthY[lane]);
    const auto edgesAt = [&](int k, int column) {
        const auto rise = hn::Mul(hn::Iota(di32, 0), hn::Set(di32, batch.edgeX[k][lane]));
        return hn::Add(rise, hn::Set(di32, batch.edge[k][lane] + column * batch.edgeX[k][lane]));
    };
    const auto down0 = hn::Set(di32, batch.edgeY[0][lane]), down1 = hn::Set(di32, batch.edgeY[1][lane]),
               down2 = hn::Set(di32, batch.edgeY[2][lane]);
    for (int x = x0; x < x1; x += int(hn::Lanes(d))) {
        auto e0 = edgesAt(0, x - x0), e1 = edgesAt(1, x - x0), e2 = edgesAt(2, x - x0);
        const auto inBox = hn::Lt(hn::Iota(di, 0), hn::Set(di, x1 - x));
        const auto fromA = hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, double(kSubpixels))),
                                   hn::Set(d, double(batch.fromAX[lane] + (x - x0) * kSubpixels)));
        const auto alongX = hn::Mul(fromA, depthX);
        auto fromAY = hn::Set(d, double(batch.fromAY[lane]));
        std::uint64_t* at = &keys.key[y0 - tile.y0][x - tile.x0];
        for (int y = y0; y < y1; ++y, at += TileKeys::kSize) {
            const auto signs = hn::PromoteTo(di, hn::Or(e0, hn::Or(e1, e2)));
            const auto inside = hn::And(hn::Gt(signs, hn::Set(di, -1)), inBox);
            const auto plane = hn::Add(alongX, hn::Add(depth, hn::Mul(depthY, fromAY)));
            const auto clamped = hn::Add(hn::Min(hn::Max(hn::DemoteTo(df, plane), lowest), highest), bias);
            const auto key = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(du, hn::BitCast(du32, clamped))), notId);
            const auto before = hn::LoadU(du, at);
            const auto shows = hn::AndNot(hn::Lt(key, farthest), hn::RebindMask(du, inside));
            const auto nearer = hn::And(hn::Gt(key, before), shows);
            hn::StoreU(hn::IfThenElse(nearer, key, before), du, at);
            e0 = hn::Add(e0, down0);
            e1 = hn::Add(e1, down1);
            e2 = hn::Add(e2, down2);
            fromAY = hn::Add(fromAY, hn::Set(d, double(kSubpixels)));
        }
    }
}

void drawAll(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
             const Extent& tile, const DrawRule& rule, const TileDepths* drawn, TileKeys& keys)
{
    const std::size_t lanes = hn::Lanes(DI());
    const std::uint64_t farKey = std::uint64_t(std::bit_cast<std::uint32_t>(rule.farInvDepth)) << 32;
    Batch batch;
    for (std::size_t begin = 0; begin < ids.size(); begin += lanes) {
        const std::size_t count = std::min(lanes, ids.size() - begin);
        batch.take(ids.subspan(begin, count));
        setUp(mesh, screen, tile, 0, rule, batch);
        for (std::size_t i = 0; i < count; ++i) {
            if (batch.isLarge[i]) {
                const auto [a, b, c] = mesh.triangles[batch.id[i]];
                drawTriangle(cornerOf(screen[a]), cornerOf(screen[b]), cornerOf(screen[c]), batch.id[i], tile, rule,
                             drawn, keys);
            } else if (batch.isReady[i] &&
                       !(drawn && drawn->hide(batch.highest[i] + batch.bias[i], batch.x0[i] - tile.x0,
                                              batch.y0[i] - tile.y0, batch.x1[i] - tile.x0, batch.y1[i] - tile.y0))) {
                drawSmall(batch, i, tile, farKey, keys);
            }
        }
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(drawAll);

void drawTriangles(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
                   const Extent& tile, const DrawRule& rule, const TileDepths* drawn, TileKeys& keys)
{
    HWY_DYNAMIC_DISPATCH(drawAll)(mesh, screen, ids, tile, rule, drawn, keys);
}

}  // namespace aeolic::cpu
#endif
