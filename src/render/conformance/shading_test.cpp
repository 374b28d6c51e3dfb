#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/reference.h"
#include "render_testing.h"

/// The blending stage of every backend against its formulas in double precision (shading_model.h).
namespace aeolic {
namespace {

using namespace testkit;

class ShadingConformance : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, ShadingConformance, allBackends, backendName);

Scene coloredScene(bool withMask)
{
    SurfaceMesh mesh = makeBuiltinScene("torus:2000", "uniform:2,2,2").surface;
    setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(-p.y, p.x, 0.3); });
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        mesh.cellScalars.push_back(withMask && i % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : float(i % 97));
    Scene scene = makeScene(std::move(mesh));
    scene.scalarRange = {10, 80};  // Values beyond either end are clamped.
    return scene;
}

/// Every channel within 1 of 255 (erf by a polynomial, rounding).
void expectReference(Stages& stages, const ShadingOptions& shading, int width = 90, int height = 70)
{
    const LicOptions lic = directLic(12);
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, width, height), lic);
    const Image<float>& values = stages.convolve(lic);
    Palette palette = makePalette(shading, stages.scene.hasScalar, stages.scene.scalarRange);
    palette.antialias = false;  // Every pixel by itself.
    Tile tile;
    tile.resize(buffer.valid());
    stages.backend->shade(palette, buffer.valid(), tile);
    stages.backend->finish();

    std::vector<double> z;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) z.push_back(double(values.at(x, y)));
    const auto expected = reference::shade(reference::fromGBuffer(buffer), z, palette);
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            ASSERT_NEAR(double(tile.rgba[4 * i + c]), expected[i][c], 1.0) << "pixel " << i << " channel " << c;
}

TEST_P(ShadingConformance, PlainSurface)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:2000", "abc:16,16,16"));
    for (const double blend : {0.0, 0.8, 1.0})
        for (const double contrast : {0.0, 1.0, 10.0})
            for (const bool lighting : {true, false}) {
                ShadingOptions shading;
                shading.blend = blend;
                shading.contrast = contrast;
                shading.lighting = lighting;
                shading.background = "204060";
                SCOPED_TRACE("blend " + std::to_string(blend) + ", contrast " + std::to_string(contrast));
                expectReference(stages, shading);
            }
}

TEST_P(ShadingConformance, ColorMapsWithAndWithoutAMask)
{
    for (const bool withMask : {false, true}) {
        Stages stages(GetParam(), coloredScene(withMask));
        for (const char* colorMap : {"viridis", "turbo", "coolwarm", "gray"}) {
            ShadingOptions shading;
            shading.colormap = colorMap;
            SCOPED_TRACE(colorMap);
            expectReference(stages, shading);
        }
    }
}

TEST_P(ShadingConformance, EveryScaleWithColoursBeyondTheRange)
{
    Stages stages(GetParam(), coloredScene(true));
    const auto [lo, hi] = stages.scene.scalarRange;
    for (const char* scale : {"linear", "log", "bands:2", "bands:7", "bands:256"})
        for (const bool beyond : {false, true}) {
            ShadingOptions shading;
            shading.colorScale = scale;
            const double least = std::max(lo, 1e-3 * hi);
            if (beyond) {
                shading.belowColor = "0000ff";
                shading.aboveColor = "ff00ff";
                shading.nanColor = "00ff00";
                shading.colorRange = {{least + 0.3 * (hi - least), least + 0.6 * (hi - least)}};
            }
            SCOPED_TRACE(scale);
            expectReference(stages, shading);
        }
}

TEST_P(ShadingConformance, ColorRangeWithoutWidth)
{
    Stages stages(GetParam(), coloredScene(false));
    ShadingOptions shading;
    shading.colorRange = {{40, 40}};
    expectReference(stages, shading);
}

TEST_P(ShadingConformance, EverySimdTargetAndOddSizes)
{
    Stages stages(GetParam(), coloredScene(true));
    forEachSimdTarget([&] {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(33, 7), std::pair(64, 3)})
            expectReference(stages, {}, width, height);
    });
}

TEST_P(ShadingConformance, BackgroundIsTakenAsGiven)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:800", "abc:8,8,8"));
    const LicOptions lic = directLic(4);
    for (const auto& [text, rgba] : {std::pair<std::string, std::array<int, 4>>{"0a80ff", {10, 128, 255, 255}},
                                     {"transparent", {255, 255, 255, 0}}}) {
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 30, 30), lic);
        ShadingOptions shading;
        shading.background = text;
        Tile tile;
        tile.resize(buffer.valid());
        stages.convolve(lic);
        stages.backend->shade(makePalette(shading, false, {0, 1}), buffer.valid(), tile);
        stages.backend->finish();
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(int(tile.row(0)[c]), rgba[c]) << text;
        EXPECT_EQ(int(tile.row(15)[4 * 15 + 3]), 255) << text;
    }
}

/// A sphere in a flow, plain or coloured by its vectors' length.
Scene maskedScene(const std::string& flow, bool colored)
{
    Scene scene = makeBuiltinScene("sphere:2000", flow);
    scene.hasScalar = colored;
    if (colored) scene.ofVectors = ArrayPart::length;
    scene.scalarRange = {0, scene.maxVector};
    return scene;
}

/// Where the vector is shorter than the mask the base alone shows, and all else is as without it.
TEST_P(ShadingConformance, AMaskHidesStreaksWhereVectorsAreShortAndNowhereElse)
{
    for (const bool colored : {false, true})
        for (const char* map : {"viridis", "gray"}) {
            Stages stages(GetParam(), maskedScene("abc:16,16,16", colored));
            LicOptions lic = directLic(10);
            ShadingOptions shading;
            shading.colormap = map;
            shading.antialias = false;
            const Camera camera = fitCamera(stages.scene, {}, 90, 90);
            const auto draw = [&](double maskBelow, double contrast) {
                lic.maskBelow = maskBelow;
                shading.contrast = contrast;
                const GBuffer& buffer = stages.project(camera, lic);
                Tile tile;
                tile.resize(buffer.valid());
                stages.convolve(lic);
                stages.backend->shade(makePalette(shading, stages.scene.hasScalar, stages.scene.scalarRange),
                                      buffer.valid(), tile);
                stages.backend->finish();
                return tile;
            };
            const Tile open = draw(0, 1), half = draw(0.5 * stages.scene.maxVector, 1), none = draw(1e30, 1),
                       none2 = draw(1e30, 9);
            EXPECT_EQ(none.rgba, none2.rgba) << "no streak is left that contrast could change";
            int hidden = 0, shown = 0;
            for (std::size_t i = 0; i < half.rgba.size(); i += 4) {
                const auto same = [&](const Tile& other) {
                    return std::equal(&half.rgba[i], &half.rgba[i] + 4, &other.rgba[i]);
                };
                ASSERT_TRUE(same(open) || same(none)) << i;
                if (same(open) && same(none)) continue;
                (same(open) ? shown : hidden) += 1;
            }
            EXPECT_GT(hidden, 300);
            EXPECT_GT(shown, 300);
        }
}

/// A masked pixel has the colour map's own colour, by light.
TEST_P(ShadingConformance, MaskedPixelsHaveTheColourMapsColours)
{
    Stages stages(GetParam(), maskedScene("uniform:8,8,8", true));
    LicOptions lic = directLic(4);
    lic.maskBelow = 100 * stages.scene.maxVector;
    for (const std::string_view map : colorMapNames()) {
        ShadingOptions shading;
        shading.colormap = map;
        shading.lighting = false;
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 30, 30), lic);
        Tile tile;
        tile.resize(buffer.valid());
        stages.convolve(lic);
        stages.backend->shade(makePalette(shading, true, {1e-3, 2e3}), buffer.valid(), tile);
        stages.backend->finish();
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(int(tile.row(15)[4 * 15 + int(c)]), int(colorMap(map)[0][c])) << map << " " << c;
    }
}

/// The tone of a unit-variance LIC is spread evenly: every tenth of the grays has a tenth of the pixels.
TEST_P(ShadingConformance, ToneHasAnEvenHistogram)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:800", "abc:8,8,8"));
    const LicOptions lic = directLic(4);
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 100, 100), lic);
    Image<float> normal;
    normal.resize(buffer.valid());
    double quantile = 0;  // Gaussian values by the sum of twelve uniform ones.
    std::uint32_t state = 1;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            quantile = -6;
            for (int i = 0; i < 12; ++i) quantile += double(state = state * 1664525u + 1013904223u) / 4294967296.0;
            normal.at(x, y) = float(quantile);
        }
    ShadingOptions shading;
    shading.lighting = false;
    shading.blend = 1;
    Tile tile;
    tile.resize(buffer.valid());
    stages.convolve(lic);
    stages.backend->probe().setLic(normal);
    stages.backend->shade(makePalette(shading, false, {0, 1}), buffer.valid(), tile);
    stages.backend->finish();
    std::array<int, 10> histogram{};
    int count = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            if (!(buffer.invDepth.at(x, y) > 0)) continue;
            ++histogram[std::size_t(int(tile.row(y)[4 * x]) * 10 / 256)];
            ++count;
        }
    for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(histogram[i], 0.1 * count, 0.025 * count) << i;
}

}  // namespace
}  // namespace aeolic
