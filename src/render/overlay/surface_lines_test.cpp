#include "render/overlay/surface_lines.h"

#include <gtest/gtest.h>

#include "render/overlay/text_size.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;
using Pixel = std::array<std::uint8_t, 4>;

constexpr int kSide = 41, kMiddle = 20;
constexpr double kFar = 10;
constexpr Pixel kGround{100, 100, 100, 255}, kLine{200, 0, 0, 255}, kCasing{255, 255, 255, 255};

/// The plane z = 0, and something near the eye, so that the view shows what is between.
Scene planeAndMore()
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {5, 0, 0}, {0, 5, 0});
    append(mesh, makeRectangle({0, 0, 9}, {0.01, 0, 0}, {0, 0.01, 0}));
    return makeScene(mesh);
}

/// A plane that faces the camera, a line or mark on it, and what a rank with some rows draws of it.
class SurfaceLinesTest : public testing::Test {
protected:
    SurfaceLinesTest() : scene_(planeAndMore()), view_(makeView(frontCamera(scene_, kFar, kSide, kSide), scene_, {}))
    {
        // The look is chosen for 800x800; here 1 pixel has to be 1 pixel.
        style_.look = {{200, 0, 0}, {255, 255, 255}, 3 * scale_, 1 * scale_, 11 * scale_};
    }

    /// A place of the plane, in pixels from the middle one's centre: to the right and upwards.
    glm::vec3 at(double right, double up, double towards = 0) const
    {
        const double world = kFar / double(view_.focalPx);
        return glm::vec3(glm::dvec3(right * world, up * world, towards) - scene_.surface.originWorld);
    }

    Tile drawn(const Extent& rows)
    {
        SeenSurface seen;
        seen.resize(rows);
        Tile out;
        out.resize(rows);
        for (int y = rows.y0; y < rows.y1; ++y)
            for (int x = 0; x < kSide; ++x) {
                seen.invDepth.at(x, y) = float(view_.unitWorld / kFar);
                seen.gradX.at(x, y) = seen.gradY.at(x, y) = 0;
                out.put(x, y, kGround);
            }
        SurfaceLines({style_}).draw(view_, seen, out);
        return out;
    }
    Tile drawn() { return drawn({0, 0, kSide, kSide}); }

    static Pixel pixel(const Tile& tile, int right, int up)
    {
        Pixel found{};
        std::copy_n(tile.row(kMiddle - up) + 4 * std::ptrdiff_t(kMiddle + right), 4, found.begin());
        return found;
    }

    Scene scene_;
    View view_;
    SurfaceLines::Style style_;
    /// Undoes what the look is multiplied by in so small a picture.
    const float scale_ = float(textSize(800, 800) / textSize(kSide, kSide));
};

TEST_F(SurfaceLinesTest, ALineHasItsWidthAndACasing)
{
    style_.lines = {{at(-100, 0), at(100, 0)}};
    const Tile tile = drawn();
    for (const int right : {-20, -3, 0, 20}) {
        for (const int up : {-1, 0, 1}) EXPECT_EQ(pixel(tile, right, up), kLine) << right << ' ' << up;
        for (const int up : {-2, 2}) EXPECT_EQ(pixel(tile, right, up), kCasing) << right << ' ' << up;
        for (const int up : {-3, 3}) EXPECT_EQ(pixel(tile, right, up), kGround) << right << ' ' << up;
    }
}

TEST_F(SurfaceLinesTest, EdgesAreSmooth)
{
    style_.lines = {{at(-100, 0.25), at(100, 0.25)}};
    const Pixel above = pixel(drawn(), 0, 2), below = pixel(drawn(), 0, -1);
    EXPECT_GT(above[0], kLine[0]);  // A quarter of it is line, the rest is casing.
    EXPECT_NEAR(above[1], 191, 2);
    EXPECT_NEAR(below[1], 64, 2);
}

/// Where a line crosses itself, and where two of a style cross, no casing cuts through the other.
TEST_F(SurfaceLinesTest, LinesOfOneStyleJoin)
{
    style_.lines = {{at(-100, 0), at(100, 0)}, {at(0, -100), at(0, 100)}};
    const Tile tile = drawn();
    for (const int i : {-1, 0, 1})
        for (const int j : {-3, -2, 2, 3}) {
            EXPECT_EQ(pixel(tile, i, j), kLine);
            EXPECT_EQ(pixel(tile, j, i), kLine);
        }
}

TEST_F(SurfaceLinesTest, WhatTheSurfaceHidesIsNotDrawn)
{
    style_.lines = {{at(-100, 0, -1), at(100, 0, -1)}};
    for (const int up : {-2, 0, 2}) EXPECT_EQ(pixel(drawn(), 0, up), kGround) << up;
    style_.lines = {{at(-100, 0, 1), at(100, 0, 1)}};
    EXPECT_EQ(pixel(drawn(), 0, 0), kLine);
    // Half of it is behind the plane, by more than a line on a surface can be for want of precision.
    style_.lines = {{at(-20, 0, -2), at(20, 0, 2)}};
    EXPECT_EQ(pixel(drawn(), -10, 0), kGround);
    EXPECT_EQ(pixel(drawn(), 10, 0), kLine);
}

TEST_F(SurfaceLinesTest, LinesThatGoBehindTheEyeEndThere)
{
    style_.lines = {{at(0, 0, 0), at(0, 4, 30)}, {at(0, 0, 40), at(0, 0, 50)}};
    const Tile tile = drawn();
    EXPECT_EQ(pixel(tile, 0, 0), kLine);
    EXPECT_EQ(pixel(tile, 0, 10), kLine);
    EXPECT_EQ(pixel(tile, 0, -10), kGround);
}

TEST_F(SurfaceLinesTest, Marks)
{
    const auto marked = [&](MarkShape shape) {
        style_.marks = {{at(0, 0), shape}};
        return drawn();
    };
    const Tile disc = marked(MarkShape::disc), ring = marked(MarkShape::ring), dot = marked(MarkShape::ringWithDot),
               cross = marked(MarkShape::cross);
    for (const Tile* tile : {&disc, &ring, &dot}) {
        EXPECT_EQ(pixel(*tile, 4, 0), kLine);
        EXPECT_EQ(pixel(*tile, 0, -4), kLine);
        EXPECT_EQ(pixel(*tile, 6, 0), kCasing);
        EXPECT_EQ(pixel(*tile, 8, 0), kGround);
    }
    EXPECT_EQ(pixel(disc, 0, 0), kLine);
    EXPECT_NE(pixel(ring, 0, 0), kLine);
    EXPECT_EQ(pixel(dot, 0, 0), kLine);
    EXPECT_NE(pixel(dot, 2, 0), kLine);
    for (const int i : {-2, 0, 2})
        for (const int sign : {-1, 1}) EXPECT_EQ(pixel(cross, i, sign * i), kLine);
    EXPECT_EQ(pixel(cross, 5, 0), kGround);
}

TEST_F(SurfaceLinesTest, RowsShowWhatTheWholePictureShows)
{
    style_.lines = {{at(-18, -17), at(3, 4), at(19, 11)}};
    style_.marks = {{at(3, 4), MarkShape::ring}, {at(-10, 12), MarkShape::cross}};
    const Tile whole = drawn();
    for (const int first : {0, 7, 16, 33}) {
        const Tile rows = drawn({0, first, kSide, std::min(first + 11, kSide)});
        for (int y = rows.extent.y0; y < rows.extent.y1; ++y)
            EXPECT_TRUE(std::equal(rows.row(y), rows.row(y) + std::ptrdiff_t(4) * kSide, whole.row(y))) << y;
    }
}

TEST_F(SurfaceLinesTest, OverATransparentBackgroundTheyAreOpaqueInTheMiddle)
{
    SeenSurface seen;
    const Extent all{0, 0, kSide, kSide};
    seen.resize(all);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) seen.invDepth.at(x, y) = seen.gradX.at(x, y) = seen.gradY.at(x, y) = 0;
    Tile out;
    out.resize(all);
    std::fill(out.rgba.begin(), out.rgba.end(), std::uint8_t{0});
    style_.lines = {{at(-100, 0), at(100, 0)}};
    SurfaceLines({style_}).draw(view_, seen, out);
    EXPECT_EQ(pixel(out, 0, 0), kLine);
    EXPECT_EQ(pixel(out, 0, 5)[3], 0);
}

}  // namespace
}  // namespace aeolic
