#include "render/cpu/edges/edge_colors.h"

#include <gtest/gtest.h>

#include <array>

#include "description/colormap.h"
#include "render/surface_mark.h"
#include "render_testing.h"

/// An edge between two surfaces of which each has its own colours: what no pixel's centre shows has those of the one
/// that is nearest in depth.
namespace aeolic::cpu {
namespace {

constexpr Extent kImage{0, 0, 64, 4};
constexpr int kColumn = 3, kRow = 1;               // The edge's pixel. The other surface is to the right.
constexpr float kOwnDepth = 1, kOtherDepth = 0.5;  // 1/depth. Flat, so that nothing between belongs to either.

/// The first surface has the first colour of one map, the second one the last of another.
struct TwoTables {
    GBuffer buffer;
    View view;
    Palette palette;
    Image<float> lic, open;
    Scene scene = testkit::makeScene(testkit::makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    SceneArrays arrays{scene};
    Tile shown;
    EdgeMask mask;
    EdgePixels pixels;
    EdgeSamples samples;

    TwoTables()
    {
        view.focalPx = 1000;
        view.camera.width = kImage.width();
        view.camera.height = kImage.height();
        buffer.resize(kImage, true, true);
        for (int y = 0; y < kImage.height(); ++y)
            for (int x = 0; x < kImage.width(); ++x) {
                buffer.invDepth.at(x, y) = buffer.gradX.at(x, y) = buffer.gradY.at(x, y) = 0;
                buffer.light.at(x, y) = 1;
                buffer.scalar.at(x, y) = 0;
                buffer.colors.at(x, y) = 0;
            }
        const auto put = [&](int x, float invDepth, float scalar, std::uint8_t table) {
            buffer.invDepth.at(x, kRow) = invDepth;
            buffer.scalar.at(x, kRow) = scalar;
            buffer.colors.at(x, kRow) = table;
        };
        put(kColumn, kOwnDepth, 0, surface_mark::kFirstColors);
        put(kColumn + 1, kOtherDepth, 1, surface_mark::kFirstColors + 1);
        ShadingOptions shading;
        shading.lighting = false;
        shading.blend = 0;
        SceneColors own, other;
        own.colorMap = "turbo";
        other.colorMap = "viridis";
        palette = makePalette(shading, {own, other}, {});
        shown.resize(kImage);
        mask.clear(kImage);
        mask.row(kRow)[0] = std::uint64_t{1} << kColumn;
        pixels.find(mask, kImage);
        samples.resize(1);
    }

    /// The pixel's colour where its samples show these 1/depths.
    Color mixed(const std::array<float, antialias::kSamples>& invDepths)
    {
        for (std::size_t s = 0; s < invDepths.size(); ++s) {
            samples.invDepth[s] = invDepths[s];
            samples.gradX[s] = samples.gradY[s] = 0;
            samples.light[s] = 1;
        }
        std::uint32_t rgba = 0;
        mixEdges(pixels, samples, 0, {{buffer, lic, open, palette}, arrays, view}, {kImage, &shown, nullptr, nullptr},
                 &rgba);
        return {std::uint8_t(rgba), std::uint8_t(rgba >> 8), std::uint8_t(rgba >> 16)};
    }
};

TEST(EdgeColors, WhatNoCentreShowsHasTheColoursOfTheNearestSurface)
{
    TwoTables edge;
    ASSERT_EQ(edge.pixels.count(), 1u);
    const Color own = colorMap("turbo").front(), other = colorMap("viridis").back();
    constexpr float nearOwn = 0.9f, nearOther = 0.6f;
    std::array<float, antialias::kSamples> invDepths{};
    for (int count = 0; count <= antialias::kSamples; ++count) {
        for (int s = 0; s < antialias::kSamples; ++s) invDepths[std::size_t(s)] = s < count ? nearOther : nearOwn;
        Color expected{};
        for (std::size_t c = 0; c < 3; ++c) {
            const int sum = count * other[c] + (antialias::kSamples - count) * own[c];
            expected[c] = std::uint8_t((sum + antialias::kSamples / 2) / antialias::kSamples);
        }
        EXPECT_EQ(edge.mixed(invDepths), expected) << count << " samples of the other surface";
    }
}

/// It lies in the hollow that the nearest surface lies in.
TEST(EdgeColors, WhatNoCentreShowsIsAsDarkAsTheNearestSurface)
{
    TwoTables edge;
    edge.palette.lighting = edge.palette.occlusion = true;
    edge.open.resize(kImage);
    edge.open.at(kColumn, kRow) = 1;
    edge.open.at(kColumn + 1, kRow) = 0.5;
    std::array<float, antialias::kSamples> invDepths;
    invDepths.fill(0.9f);
    EXPECT_EQ(edge.mixed(invDepths), colorMap("turbo").front());
    invDepths.fill(0.6f);
    const Color full = colorMap("viridis").back(), found = edge.mixed(invDepths);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], 0.5 * full[c], 1) << c;
}

}  // namespace
}  // namespace aeolic::cpu
