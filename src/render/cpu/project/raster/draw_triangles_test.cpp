#include "render/cpu/project/raster/draw_triangles.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kTile{640, 128, 640 + TileKeys::kSize, 128 + TileKeys::kSize};

/// Triangles by their corners' sub-pixels, each with points of its own.
struct Triangles {
    SurfaceMesh mesh;
    ScreenVertices screen;

    void add(const std::vector<Corner>& corners)
    {
        const auto first = std::uint32_t(screen.size());
        for (const Corner& corner : corners) {
            screen.push_back({std::int32_t(corner.x), std::int32_t(corner.y), corner.invDepth});
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
};

std::unique_ptr<TileKeys> emptyTile()
{
    auto keys = std::make_unique<TileKeys>();
    std::memset(keys.get(), 0, sizeof *keys);
    return keys;
}

/// All of them together, and one after the other.
void expectAsOneByOne(const Triangles& triangles, float farInvDepth, const TileDepths* drawn, const std::string& what)
{
    const auto together = emptyTile(), single = emptyTile();
    std::vector<std::uint32_t> ids(triangles.mesh.triangles.size());
    std::iota(ids.begin(), ids.end(), 0u);
    drawTriangles(triangles.mesh, triangles.screen, ids, kTile, DrawRule{farInvDepth}, drawn, *together);
    for (const std::uint32_t id : ids) {
        const auto& t = triangles.mesh.triangles[id];
        const auto corner = [&](std::size_t k) {
            const ScreenVertex& point = triangles.screen[t[k]];
            return Corner{point.x, point.y, point.invDepth};
        };
        drawTriangle(corner(0), corner(1), corner(2), id, kTile, DrawRule{farInvDepth}, drawn, *single);
    }
    EXPECT_EQ(std::memcmp(together->key, single->key, sizeof single->key), 0) << what;
}

/// Anywhere in and around the tile, with corners as far apart as `spanPx`; some have no area, some reach far.
Triangles someTriangles(int count, double spanPx, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Triangles triangles;
    for (int i = 0; i < count; ++i) {
        const double x = kTile.x0 - 10 + 84 * unit(random), y = kTile.y0 - 10 + 84 * unit(random);
        std::vector<Corner> corners;
        for (int k = 0; k < 3; ++k)
            corners.push_back({std::int64_t((x + spanPx * unit(random)) * kSubpixels),
                               std::int64_t((y + spanPx * unit(random)) * kSubpixels), float(0.1 + unit(random))});
        if (i % 17 == 0) corners[2] = corners[1];
        if (i % 19 == 0) corners[2].x = corners[1].x = corners[0].x;
        if (i % 23 == 0) corners[1].x += std::int64_t{1} << 26;
        if (i % 29 == 0) corners[1].y -= std::int64_t{1} << 28;
        triangles.add(corners);
    }
    return triangles;
}

TEST(DrawTriangles, TheSameKeysAsOneByOne)
{
    testkit::forEachSimdTarget([] {
        for (const double spanPx : {0.3, 1.5, 6.0, 20.0, 63.9, 64.1, 200.0})
            for (const int count : {1, 2, 15, 16, 17, 200}) {
                const Triangles triangles = someTriangles(count, spanPx, std::uint32_t(count));
                const std::string what = std::to_string(count) + " of " + std::to_string(spanPx) + " pixels";
                expectAsOneByOne(triangles, 0, nullptr, what);
                expectAsOneByOne(triangles, 0.6f, nullptr, what + ", some too far");
            }
    });
}

TEST(DrawTriangles, WhatIsHiddenIsLeftOut)
{
    const auto keys = emptyTile();
    const std::int64_t x = kTile.x0 * kSubpixels, y = kTile.y0 * kSubpixels, side = 64 * kSubpixels;
    drawTriangle({x, y, 0.7f}, {x, y + 2 * side, 0.7f}, {x + 2 * side, y, 0.7f}, 5, kTile, {}, nullptr, *keys);
    const TileDepths drawn = farthestDepths(*keys);
    expectAsOneByOne(someTriangles(100, 9, 3), 0, &drawn, "behind a wall");
    const auto behind = emptyTile();
    Triangles far;
    far.add({{x, y, 0.2f}, {x, y + side, 0.2f}, {x + side, y, 0.2f}});
    const std::vector<std::uint32_t> ids{0};
    drawTriangles(far.mesh, far.screen, ids, kTile, {}, &drawn, *behind);
    EXPECT_EQ(behind->key[3][3], 0u);
}

TEST(DrawTriangles, NoneIsFine)
{
    const auto keys = emptyTile();
    drawTriangles({}, {}, {}, kTile, {}, nullptr, *keys);
    EXPECT_EQ(keys->key[0][0], 0u);
}

}  // namespace
}  // namespace aeolic::cpu
