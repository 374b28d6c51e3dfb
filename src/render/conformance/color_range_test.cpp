#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "render/palette.h"
#include "render_testing.h"

/// Colours at the ends of a range, and a hair beyond.
namespace aeolic {
namespace {

using namespace testkit;

class ColorRange : public BackendTest {
protected:
    /// The colour of each of these scalars, without streaks and light.
    static std::vector<Color> colorsOf(const std::vector<float>& scalars, ShadingOptions shading)
    {
        const int count = int(scalars.size());
        SurfaceMesh mesh;
        for (int i = 0; i < count; ++i) {
            append(mesh, makeRectangle({(i - 0.5 * (count - 1)) / count, 0, 0}, {0.5 / count, 0, 0}, {0, 1, 0}));
            mesh.cellScalars.resize(mesh.triangles.size(), scalars[std::size_t(i)]);
        }
        setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        LicOptions lic;
        lic.method = LicMethod::none;
        shading.lighting = shading.antialias = false;
        shading.blend = 0;
        const Camera camera = frontCamera(stages.scene, 4, 20 * count, 16, 10);
        const GBuffer& buffer = stages.project(camera, lic);
        Tile tile;
        tile.resize(buffer.valid());
        stages.convolve(lic);
        stages.backend->shade(makePalette(shading, true, {0, 1}), buffer.valid(), tile);
        stages.backend->finish();
        std::vector<Color> colors;
        for (int i = 0; i < count; ++i) {
            const double worldX = (i - 0.5 * (count - 1)) / count;
            const std::uint8_t* p = tile.row(8) + 4 * int(10 * count + worldX * camera.focalPx / 4);
            colors.push_back({p[0], p[1], p[2]});
        }
        return colors;
    }
};
INSTANTIATE_TEST_SUITE_P(Backends, ColorRange, allBackends, backendName);

TEST_P(ColorRange, ItsEndsAreWithinIt)
{
    constexpr float lo = 2, hi = 6, more = std::numeric_limits<float>::infinity();
    for (const char* scale : {"linear", "log", "bands:2", "bands:7", "bands:256"}) {
        SCOPED_TRACE(scale);
        ShadingOptions shading;
        shading.colorScale = scale;
        shading.colormap = "turbo";
        shading.colorRange = {{double(lo), double(hi)}};
        shading.belowColor = "0000ff";
        shading.aboveColor = "ff00ff";
        shading.nanColor = "00ff00";
        const std::vector<Color> colors = colorsOf(
            {-more, std::nextafter(lo, -more), lo, hi, std::nextafter(hi, more), more, std::nanf("")}, shading);
        const Color below{0, 0, 255}, above{255, 0, 255}, masked{0, 255, 0};
        const Color first = colorMap("turbo")[0], last = colorMap("turbo")[255];
        EXPECT_EQ(colors, (std::vector<Color>{below, below, first, last, above, above, masked}));
    }
}

/// A band begins with the scalar that it is named after.
TEST_P(ColorRange, ABandHasItsLowerEnd)
{
    ShadingOptions shading;
    shading.colorScale = "bands:4";
    shading.colormap = "viridis";
    shading.colorRange = {{0.0, 4.0}};
    const std::vector<Color> colors = colorsOf({0, 0.999f, 1, 1.999f, 2, 2.999f, 3, 4}, shading);
    std::vector<Color> expected;
    for (const std::size_t entry : {0u, 85u, 170u, 255u})
        expected.insert(expected.end(), 2, colorMap("viridis")[entry]);
    EXPECT_EQ(colors, expected);
}

/// Entries of a logarithmic scale, too, begin with their lower ends: powers of two are 64 entries apart.
TEST_P(ColorRange, AnEntryOfALogarithmicScaleHasItsLowerEnd)
{
    ShadingOptions shading;
    shading.colorScale = "log";
    shading.colormap = "gray";
    shading.colorRange = {{1.0, 16.0}};
    const std::vector<Color> colors = colorsOf(
        {1, 2, std::nextafter(2.0f, 0.0f), 4, std::nextafter(4.0f, 0.0f), 8, std::nextafter(8.0f, 0.0f)}, shading);
    std::vector<Color> expected;
    for (const std::size_t entry : {0u, 64u, 63u, 128u, 127u, 192u, 191u}) expected.push_back(colorMap("gray")[entry]);
    EXPECT_EQ(colors, expected);
}

}  // namespace
}  // namespace aeolic
