#include "render/cpu/project/raster/raster.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include "render/cpu/project/raster/transform.h"
#include "render/cpu/project/raster/triangle_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/project/raster/raster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A vector of pixels at a time. Edge values below 2^53 are exact as doubles, and exact values do not depend on the
// way they are computed.
void drawRows(TriangleRows t, const Extent& tile, TileKeys& keys)
{
    const hn::ScalableTag<double> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const hn::Rebind<float, decltype(d)> df;
    const hn::Rebind<std::uint32_t, decltype(d)> du32;
    const auto zero = hn::Zero(d), lane = hn::Iota(d, 0);
    const auto notId = hn::Set(du, std::uint64_t(t.notId));
    const auto lowest = hn::Set(df, t.lowest), highest = hn::Set(df, t.highest), farthest = hn::Set(df, t.farthest),
               bias = hn::Set(df, t.bias);
    const auto rise = [&](std::int64_t perPixel) { return hn::Mul(lane, hn::Set(d, double(perPixel))); };
    const auto e0 = rise(t.edgeX[0]), e1 = rise(t.edgeX[1]), e2 = rise(t.edgeX[2]);
    for (int y = t.over.y0; y < t.over.y1; ++y) {
        std::uint64_t* row = keys.key[y - tile.y0] - tile.x0;
        const double rowDepth = t.rowDepth();
        for (int x = t.over.x0; x < t.over.x1; x += int(hn::Lanes(d))) {
            const auto start = [&](int k) { return hn::Set(d, double(t.edge[k] + (x - t.over.x0) * t.edgeX[k])); };
            const auto smallest = hn::Min(hn::Min(hn::Add(e0, start(0)), hn::Add(e1, start(1))), hn::Add(e2, start(2)));
            const auto column = hn::Add(lane, hn::Set(d, double(x - t.over.x0)));
            const auto inside =
                hn::And(hn::Ge(smallest, zero), hn::Lt(column, hn::Set(d, double(t.over.x1 - t.over.x0))));
            if (hn::AllFalse(d, inside)) continue;
            const auto fromA = hn::Add(hn::Mul(lane, hn::Set(d, double(kSubpixels))),
                                       hn::Set(d, double(t.fromAX + (x - t.over.x0) * kSubpixels)));
            const auto plane = hn::Add(hn::Mul(fromA, hn::Set(d, t.depthX)), hn::Set(d, rowDepth));
            const auto depth = hn::Add(hn::Min(hn::Max(hn::DemoteTo(df, plane), lowest), highest), bias);
            const auto key = hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(du, hn::BitCast(du32, depth))), notId);
            const auto near = hn::PromoteTo(d, hn::IfThenElseZero(hn::Ge(depth, farthest), hn::Set(df, 1.0f)));
            const auto before = hn::LoadU(du, row + x);
            const auto nearer = hn::And(hn::Gt(key, before), hn::RebindMask(du, hn::And(inside, hn::Gt(near, zero))));
            hn::StoreU(hn::IfThenElse(nearer, key, before), du, row + x);
        }
        t.nextRow();
    }
}

void farthestInBlocks(const TileKeys& keys, TileDepths& depths)
{
    // Positive floats are in the order of their bits.
    const hn::ScalableTag<std::uint32_t> d;
    constexpr int kSize = TileKeys::kSize, kBlock = TileDepths::kBlock;
    HWY_ALIGN std::uint32_t columns[kSize];
    for (int top = 0; top < kSize; top += kBlock) {
        for (int x = 0; x < kSize; x += int(hn::Lanes(d))) {
            auto least = hn::Set(d, ~0u);
            for (int y = top; y < top + kBlock; ++y) {
                hn::Vec<decltype(d)> notId, depth;
                hn::LoadInterleaved2(d, reinterpret_cast<const std::uint32_t*>(&keys.key[y][x]), notId, depth);
                least = hn::Min(least, depth);
            }
            hn::Store(least, d, columns + x);
        }
        for (int x = 0; x < kSize; x += kBlock)
            depths.farthest[top / kBlock][x / kBlock] =
                std::bit_cast<float>(*std::min_element(columns + x, columns + x + kBlock));
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(drawRows);
HWY_EXPORT(farthestInBlocks);

namespace {

// Exact: products of sub-pixel coordinates stay far below 2^63.
std::int64_t cross(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// Triangles whose edge values need more than a double's 53 bits: thousands of pixels wide, and few.
void drawWide(TriangleRows t, const Extent& tile, TileKeys& keys)
{
    for (int y = t.over.y0; y < t.over.y1; ++y) {
        std::uint64_t* row = keys.key[y - tile.y0] - tile.x0;
        const double rowDepth = t.rowDepth();
        std::int64_t e = t.edge[0], f = t.edge[1], g = t.edge[2];
        for (int x = t.over.x0; x < t.over.x1; ++x, e += t.edgeX[0], f += t.edgeX[1], g += t.edgeX[2]) {
            if ((e | f | g) < 0) continue;
            const double plane = double(t.fromAX + (x - t.over.x0) * kSubpixels) * t.depthX + rowDepth;
            const float depth = std::min(std::max(float(plane), t.lowest), t.highest) + t.bias;
            if (depth < t.farthest) continue;
            row[x] = std::max(row[x], (std::uint64_t(std::bit_cast<std::uint32_t>(depth)) << 32) | t.notId);
        }
        t.nextRow();
    }
}

}  // namespace

TileDepths farthestDepths(const TileKeys& keys)
{
    TileDepths depths;
    HWY_DYNAMIC_DISPATCH(farthestInBlocks)(keys, depths);
    return depths;
}

std::optional<TriangleRows> triangleRows(Corner a, Corner b, Corner c, std::uint32_t id, const Extent& tile, int margin,
                                         const DrawRule& rule)
{
    std::int64_t doubleArea = cross(a, b, c.x, c.y);
    const bool isFront = doubleArea < 0;  // Rows count downwards.
    if (doubleArea == 0 || (rule.frontOnly && !isFront)) return std::nullopt;
    if (isFront) {
        std::swap(b, c);
        doubleArea = -doubleArea;
    }
    // From the same corner on, so that triangles in the same place get the same depths to the last bit.
    const auto comesFirst = [](const Corner& p, const Corner& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); };
    if (comesFirst(b, a) && !comesFirst(c, b))
        std::tie(a, b, c) = std::tuple(b, c, a);
    else if (comesFirst(c, a))
        std::tie(a, b, c) = std::tuple(c, a, b);
    TriangleRows t{};
    t.over = pixelsOver(a, b, c, margin, tile);
    if (t.over.empty()) return std::nullopt;
    t.lowest = std::min({a.invDepth, b.invDepth, c.invDepth});
    t.highest = std::max({a.invDepth, b.invDepth, c.invDepth});
    if (t.highest < rule.farInvDepth) return std::nullopt;
    // 1/depth is linear in the image: its plane through the three corners, clamped to them so a sliver cannot
    // overshoot.
    const double inverseArea = 1.0 / double(doubleArea);
    const double zb = double(b.invDepth) - double(a.invDepth), zc = double(c.invDepth) - double(a.invDepth);
    t.depth = double(a.invDepth);
    t.depthX = (zb * double(c.y - a.y) - zc * double(b.y - a.y)) * inverseArea;
    t.depthY = (zc * double(b.x - a.x) - zb * double(c.x - a.x)) * inverseArea;
    t.bias = isFront ? float(frontBias(t.depthX, t.depthY, double(t.lowest), double(t.highest))) : 0.0f;

    const std::int64_t px = std::int64_t(t.over.x0) * kSubpixels + kSubpixels / 2,
                       py = std::int64_t(t.over.y0) * kSubpixels + kSubpixels / 2;
    const Corner corners[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
        const Corner &p = corners[k], &q = corners[(k + 1) % 3];
        t.edge[k] = cross(p, q, px, py);
        t.edgeX[k] = -(q.y - p.y) * kSubpixels;
        t.edgeY[k] = (q.x - p.x) * kSubpixels;
    }
    t.fromAX = px - a.x;
    t.fromAY = py - a.y;
    t.farthest = rule.farInvDepth;
    t.notId = ~id;
    constexpr std::int64_t kExactSpan = std::int64_t{1} << 24;  // Spans up to 2^24 make edge values up to 2^50.
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    t.fitsDoubles = right - left < kExactSpan && bottom - top < kExactSpan;
    return t;
}

void drawTriangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, const Extent& tile,
                  const DrawRule& rule, const TileDepths* drawn, TileKeys& keys)
{
    const std::optional<TriangleRows> t = triangleRows(a, b, c, id, tile, 0, rule);
    if (!t) return;
    const Extent& over = t->over;
    if (drawn &&
        drawn->hide(t->highest + t->bias, over.x0 - tile.x0, over.y0 - tile.y0, over.x1 - tile.x0, over.y1 - tile.y0))
        return;
    if (t->fitsDoubles)
        HWY_DYNAMIC_DISPATCH(drawRows)(*t, tile, keys);
    else
        drawWide(*t, tile, keys);
}

}  // namespace aeolic::cpu
#endif
