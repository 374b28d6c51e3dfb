#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/reference.h"
#include "render/occlusion.h"
#include "render/palette.h"
#include "render_testing.h"

/// Ambient occlusion: hollows are darker, and nothing else is.
namespace aeolic {
namespace {

using namespace testkit;

constexpr int kSide = 128;

/// What the picture shows, as gray values without streaks.
struct Grays {
    std::vector<double> plain, occluded;
    reference::PixelImage image{1, 1};
    View view;
};

class Occlusion : public BackendTest {
protected:
    static Grays draw(Scene scene, const Camera& camera, bool lighting = true)
    {
        Stages stages(GetParam(), std::move(scene));
        LicOptions lic;
        lic.method = LicMethod::none;
        const Extent whole = wholeImage(camera);
        Grays grays;
        grays.image = reference::fromGBuffer(stages.project(camera, lic));
        grays.view = stages.view;
        stages.backend->convolve(lic, whole);
        ShadingOptions shading;
        shading.blend = 0;
        shading.antialias = false;
        shading.lighting = lighting;
        for (const bool occlusion : {false, true}) {
            shading.occlusion = occlusion;
            const Palette palette = makePalette(shading, false, {0, 1});
            Tile tile;
            tile.resize(whole);
            stages.backend->occlude(palette, whole);
            stages.backend->shade(palette, whole, tile);
            stages.backend->finish();
            std::vector<double>& gray = occlusion ? grays.occluded : grays.plain;
            for (std::size_t i = 0; i < tile.rgba.size(); i += 4) gray.push_back(tile.rgba[i]);
        }
        return grays;
    }
    /// A floor, z = 0, and a wall, x = 0, seen from half-way between them.
    static Scene corner()
    {
        SurfaceMesh mesh = makeRectangle({1, 0, 0}, {1, 0, 0}, {0, 1, 0});
        append(mesh, makeRectangle({0, 0, 1}, {0, 1, 0}, {0, 0, 1}));
        setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(0, 1, 0); });
        return makeScene(std::move(mesh));
    }
    static Camera intoCorner(const Scene& scene)
    {
        CameraOptions options;
        options.position = Vec3{3, 0, 3};
        options.focal = Vec3{0.5, 0, 0.5};
        return fitCamera(scene, options, kSide, kSide);
    }
};
INSTANTIATE_TEST_SUITE_P(Backends, Occlusion, allBackends, backendName);

double depthAt(const Grays& grays, int x, int y)
{
    return x < 0 || y < 0 || x >= kSide || y >= kSide ? 0 : grays.image.at(x, y).invDepth;
}

/// occlusion.h, word by word and in double precision.
double hiddenAt(const Grays& grays, int x, int y)
{
    const int radius = kSide / 16;
    const double depth = depthAt(grays, x, y), perDepth = double(grays.view.focalPx) / depth,
                 slopeX = grays.image.at(x, y).gradX * perDepth, slopeY = grays.image.at(x, y).gradY * perDepth;
    double hides = 0;
    for (int k = 0; k < occlusion::kTaps; ++k) {
        const int at = (y % 4 * 4 + x % 4) * occlusion::kTaps + k;
        const int u = int(std::floor(occlusion::kRight[at] * radius / 1024.0 + 0.5)),
                  v = int(std::floor(occlusion::kDown[at] * radius / 1024.0 + 0.5));
        const double toEye = (depthAt(grays, x + u, y + v) - depth) * perDepth,
                     above = (toEye - slopeX * u - slopeY * v) / std::sqrt(1 + slopeX * slopeX + slopeY * slopeY),
                     far = std::max(1, u * u + v * v) + toEye * toEye;
        if (above > 0) hides += above * above / far * std::max(0.0, 1 - far / (4.0 * radius * radius));
    }
    return hides / occlusion::kTaps;
}

double openAt(const Grays& grays, int x, int y)
{
    const double depth = depthAt(grays, x, y);
    double sum = 0, count = 0;
    for (int v = -2; v < 2; ++v)
        for (int u = -2; u < 2; ++u) {
            const double there = depthAt(grays, x + u, y + v),
                         predicted = depth + grays.image.at(x, y).gradX * u + grays.image.at(x, y).gradY * v;
            if (there == 0 || std::abs(there - predicted) * double(grays.view.focalPx) / depth > 2) continue;
            sum += hiddenAt(grays, x + u, y + v);
            ++count;
        }
    return 1 / (1 + double(occlusion::kStrength) * sum / count);
}

TEST_P(Occlusion, IsWhatTheFormulaSays)
{
    SurfaceMesh cubes = makeCube({0, 0, 0}, 1);
    append(cubes, makeCube({1.2, 0.6, 0.9}, 0.8));
    setPointVectors(cubes, [](const glm::dvec3& p) { return glm::vec3(p.y, 1, 0.3); });
    for (Scene& scene :
         std::vector<Scene>{makeScene(std::move(cubes)), makeBuiltinScene("teapot:6000", "rotation:8,8,8")}) {
        CameraOptions options;
        options.zoom = 1.4;  // Some of it is beyond the picture.
        const Camera camera = fitCamera(scene, options, kSide, kSide);
        const Grays grays = draw(scene, camera);
        double darkest = 1;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const std::size_t i = std::size_t(y * kSide + x);
                if (!(grays.image.at(x, y).invDepth > 0)) {
                    ASSERT_EQ(grays.occluded[i], grays.plain[i]) << x << ' ' << y;
                    continue;
                }
                const double open = openAt(grays, x, y);
                darkest = std::min(darkest, open);
                ASSERT_NEAR(grays.occluded[i], 255 * std::abs(grays.image.at(x, y).light) * open, 1) << x << ' ' << y;
            }
        EXPECT_LE(darkest, 0.8);
    }
}

/// Nothing rises above any facet of a convex body: it does not change.
TEST_P(Occlusion, LeavesConvexBodiesAsTheyAre)
{
    SurfaceMesh cube = makeCube({0, 0, 0}, 1);
    setPointVectors(cube, [](const glm::dvec3& p) { return glm::vec3(p.y, 1, 0.3); });
    for (Scene& scene :
         std::vector<Scene>{makeScene(std::move(cube)), makeBuiltinScene("sphere:20000", "rotation:8,8,8")}) {
        const Camera camera = fitCamera(scene, {}, kSide, kSide);
        const Grays grays = draw(scene, camera);
        for (std::size_t i = 0; i < grays.plain.size(); ++i) ASSERT_NEAR(grays.occluded[i], grays.plain[i], 1) << i;
    }
}

TEST_P(Occlusion, DarkensCornersAndFadesWithinTheRadius)
{
    const Scene scene = corner();
    const Grays grays = draw(scene, intoCorner(scene));
    const auto openAlong = [&](int y) {  // The picture's middle column; the fold lies across it.
        const auto i = std::size_t(y * kSide + kSide / 2);
        return grays.occluded[i] / grays.plain[i];
    };
    int darkest = kSide / 4;
    for (int y = kSide / 4; y < 3 * kSide / 4; ++y)
        if (openAlong(y) < openAlong(darkest)) darkest = y;
    EXPECT_LE(openAlong(darkest), 0.75);
    EXPECT_GE(openAlong(darkest), 0.25) << "never black";
    const int radius = occlusion::radiusPx(kSide);
    for (const int side : {-1, 1}) {
        for (int k = 2; k < radius; ++k)
            EXPECT_LE(openAlong(darkest + side * (k - 1)), openAlong(darkest + side * k) + 0.02) << side * k;
        EXPECT_NEAR(openAlong(darkest + side * (radius + 2)), 1, 0.01);
    }
}

/// A small plate far in front of a large one has no halo.
TEST_P(Occlusion, WhatIsFarInFrontHidesNothing)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    append(mesh, makeRectangle({0, 0, 2.5}, {0.3, 0, 0}, {0, 0.3, 0}));
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    const Scene scene = makeScene(std::move(mesh));
    const Grays grays = draw(scene, frontCamera(scene, 6, kSide, kSide));
    for (std::size_t i = 0; i < grays.plain.size(); ++i) ASSERT_NEAR(grays.occluded[i], grays.plain[i], 1) << i;
}

TEST_P(Occlusion, IsNothingWithoutLight)
{
    const Scene scene = corner();
    const Grays grays = draw(scene, intoCorner(scene), false);
    EXPECT_EQ(grays.occluded, grays.plain);
}

TEST(OcclusionRadius, IsAPartOfThePictureWithinBounds)
{
    EXPECT_EQ(occlusion::radiusPx(1), 4);
    EXPECT_EQ(occlusion::radiusPx(800), 50);
    EXPECT_EQ(occlusion::radiusPx(100000), occlusion::kMostRadiusPx);
    for (const int radius : {4, 50, occlusion::kMostRadiusPx})
        for (int k = 0; k < occlusion::kPatterns * occlusion::kTaps;
             ++k) {  // Rows that come from others go no farther.
            EXPECT_LE(std::abs(occlusion::tapPx(occlusion::kRight[k], radius)), radius) << k;
            EXPECT_LE(std::abs(occlusion::tapPx(occlusion::kDown[k], radius)), radius) << k;
        }
}

}  // namespace
}  // namespace aeolic
