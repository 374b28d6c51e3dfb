#include "render/cpu/project/sample_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

constexpr Extent kTile{640, 128, 640 + TileKeys::kSize, 128 + 50};  // The picture ends within it.

bool isMarked(const EdgeMask& mask, int x, int y)
{
    return (mask.row(y)[x / 64] >> (x % 64) & 1) != 0;
}

/// One of so many pixels, and in one row all of them.
EdgeMask someEdges(int oneOf, std::uint32_t seed)
{
    std::mt19937 random(seed);
    EdgeMask mask;
    mask.clear({0, 100, kTile.x1, kTile.y1});
    for (int y = mask.rows.y0; y < mask.rows.y1; ++y)
        for (int x = 0; x < kTile.x1; ++x)
            if (random() % unsigned(oneOf) == 0 || y == kTile.y0 + 9)
                mask.row(y)[x / 64] |= std::uint64_t{1} << (x % 64);
    return mask;
}

TEST(EdgePixels, HasEachPixelOnceAndThoseOfABoxInItsRanges)
{
    EdgePixels pixels;
    for (const int oneOf : {1, 3, 40, 100000}) {  // Memory of the one before is no pixel of the next.
        const EdgeMask mask = someEdges(oneOf, 1);
        pixels.find(mask, kTile);
        std::uint32_t marked = 0;
        for (int y = kTile.y0; y < kTile.y1; ++y)
            for (int x = kTile.x0; x < kTile.x1; ++x) {
                const auto number = pixels.at(x, y);
                ASSERT_EQ(number.has_value(), isMarked(mask, x, y)) << x << ' ' << y;
                if (!number) continue;
                ++marked;
                EXPECT_EQ(pixels.x()[*number], x);
                EXPECT_EQ(pixels.y()[*number], y);
                const EdgePixels::Range range = pixels.range(pixels.strip(x), std::max(y - 2, kTile.y0), y + 1);
                EXPECT_TRUE(*number >= range.begin && *number < range.end) << x << ' ' << y;
                EXPECT_LE(range.end - range.begin, 3u * EdgePixels::kColumns);
            }
        EXPECT_EQ(pixels.count(), marked);
    }
}

struct Triangles {
    SurfaceMesh mesh;
    ScreenVertices screen;

    /// All corners that many sub-pixels to the left and upwards.
    std::vector<Corner> moved(std::uint32_t id, std::int64_t x, std::int64_t y) const
    {
        std::vector<Corner> corners;
        for (const std::uint32_t k : mesh.triangles[id])
            corners.push_back({screen[k].x - x, screen[k].y - y, screen[k].invDepth});
        return corners;
    }
};

/// In and around the tile, in front of each other, with corners as far apart as `spanPx`. Some have no area.
Triangles someTriangles(int count, double spanPx, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Triangles triangles;
    for (int i = 0; i < count; ++i) {
        const auto first = std::uint32_t(triangles.screen.size());
        const double x = kTile.x0 - 10 + 84 * unit(random), y = kTile.y0 - 10 + 84 * unit(random);
        const double depth = 0.1 + unit(random);
        for (int k = 0; k < 3; ++k) {
            const auto pointX = std::int32_t((x + spanPx * unit(random)) * kSubpixels),
                       pointY = std::int32_t((y + spanPx * unit(random)) * kSubpixels);
            triangles.screen.push_back({pointX, pointY, float(depth + 0.05 * unit(random))});
        }
        if (i % 17 == 0) triangles.screen[first + 2].x = triangles.screen[first + 1].x = triangles.screen[first].x;
        triangles.mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return triangles;
}

/// What a sample shows is what a pixel's centre does where everything lies that much to the left and upwards.
void expectAsCentres(const Triangles& triangles, const SampleKeys& drawn, float farInvDepth, const std::string& what)
{
    const EdgePixels& pixels = drawn.pixels();
    for (int s = 0; s < antialias::kSamples; ++s) {
        const auto centres = std::make_unique<TileKeys>();
        std::memset(centres.get(), 0, sizeof *centres);
        for (std::uint32_t id = 0; id < triangles.mesh.triangles.size(); ++id) {
            const std::vector<Corner> c =
                triangles.moved(id, antialias::kRight[s] * kSubpixelsPerPart, antialias::kDown[s] * kSubpixelsPerPart);
            drawTriangle(c[0], c[1], c[2], id, kTile, DrawRule{farInvDepth}, nullptr, *centres);
        }
        for (std::size_t i = 0; i < pixels.count(); ++i)
            ASSERT_EQ(drawn.key(i * antialias::kSamples + std::size_t(s)),
                      centres->key[pixels.y()[i] - kTile.y0][pixels.x()[i] - kTile.x0])
                << what << ", sample " << s << " at " << pixels.x()[i] << ' ' << pixels.y()[i];
    }
}

TEST(SampleTriangles, ShowWhatCentresShowWhereThingsAreMoved)
{
    testkit::forEachSimdTarget([] {
        for (const double spanPx : {0.3, 1.5, 6.0, 20.0, 63.9, 64.1, 200.0})
            for (const int count : {1, 16, 17, 200})
                for (const float farInvDepth : {0.0f, 0.6f}) {
                    const Triangles triangles = someTriangles(count, spanPx, std::uint32_t(count));
                    EdgePixels pixels;
                    pixels.find(someEdges(count == 17 ? 1 : 7, 2), kTile);
                    std::vector<std::uint32_t> ids(triangles.mesh.triangles.size());
                    std::iota(ids.begin(), ids.end(), 0u);
                    SampleKeys drawn;
                    drawn.clear(pixels);
                    sampleTriangles(triangles.mesh, triangles.screen, ids, DrawRule{farInvDepth}, drawn);
                    expectAsCentres(triangles, drawn, farInvDepth,
                                    std::to_string(count) + " of " + std::to_string(spanPx) + " pixels");
                }
    });
}

/// Pictures show neither the order of triangles nor which of them are known to be hidden.
TEST(SampleTriangles, WhatIsHiddenIsLeftOut)
{
    testkit::forEachSimdTarget([] {
        const Triangles triangles = someTriangles(3000, 12, 4);
        EdgePixels pixels;
        pixels.find(someEdges(5, 3), kTile);
        std::vector<std::uint32_t> ids(triangles.mesh.triangles.size());
        std::iota(ids.begin(), ids.end(), 0u);
        std::shuffle(ids.begin(), ids.end(), std::mt19937(5));
        SampleKeys drawn;
        drawn.clear(pixels);
        const std::span<const std::uint32_t> all(ids), front = all.first(2000), others = all.subspan(2000);
        sampleTriangles(triangles.mesh, triangles.screen, front, {}, drawn);
        drawn.findFarthest();
        std::size_t known = 0;
        for (std::size_t i = 0; i < pixels.count(); ++i) {
            const float* depths = drawn.depths() + i * antialias::kSamples;
            const float least = *std::min_element(depths, depths + antialias::kSamples);
            ASSERT_EQ(drawn.farthest()[i], least);
            known += least > 0;
        }
        ASSERT_GT(known, pixels.count() / 2);
        sampleTriangles(triangles.mesh, triangles.screen, others, {}, drawn);
        expectAsCentres(triangles, drawn, 0, "in parts");
        // A pixel is not even looked at where all that it shows is nearer, by small triangles or by large ones.
        for (const std::int32_t side : {40 * kSubpixels, 80 * kSubpixels}) {
            Triangles far;
            far.mesh.triangles.push_back({0, 1, 2});
            const std::int32_t x = kTile.x0 * kSubpixels, y = kTile.y0 * kSubpixels;
            far.screen = {{x, y, 0.2f}, {x, y + side, 0.2f}, {x + side, y, 0.2f}};
            const auto shown = [&](float nearer) {
                drawn.clear(pixels);
                std::fill_n(drawn.farthest(), pixels.count(), nearer);
                sampleTriangles(far.mesh, far.screen, std::vector<std::uint32_t>{0}, {}, drawn);
                return std::any_of(drawn.depths(), drawn.depths() + pixels.count() * antialias::kSamples,
                                   [](float depth) { return depth != 0; });
            };
            EXPECT_FALSE(shown(0.3f)) << side;
            EXPECT_TRUE(shown(0.2f)) << side;
        }
    });
}

}  // namespace
}  // namespace aeolic::cpu
