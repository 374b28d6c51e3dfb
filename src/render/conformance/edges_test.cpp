#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "render/palette.h"
#include "render_testing.h"

/// Anti-aliasing: edges are the mean of what they cover; everything else stays what it is.
namespace aeolic {
namespace {

using namespace testkit;

class Edges : public BackendTest {
protected:
    /// RGBA of the whole image, without streaks.
    static Tile draw(Stages& stages, const Camera& camera, ShadingOptions shading)
    {
        LicOptions lic;
        lic.method = LicMethod::none;
        const Extent whole = wholeImage(camera);
        stages.project(camera, lic);
        stages.backend->convolve(lic, whole);
        stages.backend->smooth(lic, whole, nullptr, 1);
        Tile tile;
        tile.resize(whole);
        const Palette palette = makePalette(shading, stages.scene.hasScalar, stages.scene.scalarRange);
        stages.backend->shade(palette, whole, tile);
        stages.backend->finish();
        return tile;
    }
    static Tile draw(const Scene& scene, const Camera& camera, bool antialias, const std::string& background = "ffffff",
                     bool lighting = true)
    {
        Stages stages(GetParam(), scene);
        ShadingOptions shading;
        shading.antialias = antialias;
        shading.background = background;
        shading.lighting = lighting;
        return draw(stages, camera, shading);
    }
};
INSTANTIATE_TEST_SUITE_P(Backends, Edges, allBackends, backendName);

double channel(const Tile& tile, int x, int y, int c)
{
    return double(tile.row(y)[4 * x + c]);
}

bool same(const Tile& a, const Tile& b, int x, int y)
{
    return std::equal(a.row(y) + 4 * x, a.row(y) + 4 * x + 4, b.row(y) + 4 * x);
}

/// A picture eight times as large in both directions, averaged down: red.
double eightfold(const Tile& large, int x, int y)
{
    double sum = 0;
    for (int v = 0; v < 8; ++v)
        for (int u = 0; u < 8; ++u) sum += channel(large, 8 * x + u, 8 * y + v, 0);
    return sum / 64;
}

/// How far edge pixels are from an eightfold picture: the root mean square, with anti-aliasing over that without.
double errorLeft(const Scene& scene, const std::string& backend, int width, int height,
                 const std::function<Tile(const Camera&, bool)>& draw)
{
    SCOPED_TRACE(backend);
    CameraOptions options;
    options.azimuth = 30;
    options.elevation = 20;
    const Tile plain = draw(fitCamera(scene, options, width, height), false),
               smooth = draw(fitCamera(scene, options, width, height), true),
               large = draw(fitCamera(scene, options, 8 * width, 8 * height), false);
    double before = 0, after = 0;
    int count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (same(plain, smooth, x, y)) continue;
            const double truth = eightfold(large, x, y);
            before += std::pow(channel(plain, x, y, 0) - truth, 2);
            after += std::pow(channel(smooth, x, y, 0) - truth, 2);
            ++count;
        }
    EXPECT_GT(count, width / 2);
    return std::sqrt(after / before);
}

TEST_P(Edges, AreTheMeanOfAnEightfoldPicture)
{
    SurfaceMesh cubes = makeCube({0, 0, 0}, 1);
    append(cubes, makeCube({0.9, 0.6, 0.7}, 0.8));  // They cross.
    setPointVectors(cubes, [](const glm::dvec3& p) { return glm::vec3(p.y, 1, 0.3); });
    const Scene crossing = makeScene(std::move(cubes));
    const int side =
        GetParam() == "gl" ? 90 : 160;  // What a program on the processor plays the GPU in, it plays slowly.
    const auto left = [&](const Scene& scene) {
        return errorLeft(scene, GetParam(), side, side,
                         [&](const Camera& camera, bool antialias) { return draw(scene, camera, antialias); });
    };
    EXPECT_LE(left(makeBuiltinScene("teapot:20000", "tornado:8,8,8")), 0.25);
    EXPECT_LE(left(makeBuiltinScene("torus:6000", "tornado:8,8,8")), 0.25);
    EXPECT_LE(left(crossing), 0.25);
}

/// A large triangle's edge on a transparent background: alpha is what it covers of each pixel.
TEST_P(Edges, AlphaIsTheShareThatIsCovered)
{
    constexpr int kSide = 96;
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {0.9, 0.35, 0}, {-0.35, 0.9, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    const Scene scene = makeScene(std::move(mesh));
    const Camera camera = frontCamera(scene, 6, kSide, kSide);
    const Tile tile = draw(scene, camera, true, "transparent", false);
    const double pixels = kSide / (2 * 6 * std::tan(15 * std::acos(-1) / 180));  // Per world unit.
    double sum = 0, worst = 0, squared = 0;
    int edges = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double alpha = channel(tile, x, y, 3) / 255;
            sum += alpha;
            int covered = 0;
            constexpr int kFine = 32;
            for (int v = 0; v < kFine; ++v)
                for (int u = 0; u < kFine; ++u) {
                    const double px = (x + (u + 0.5) / kFine - kSide / 2.0) / pixels,
                                 py = (kSide / 2.0 - y - (v + 0.5) / kFine) / pixels, size = 0.9 * 0.9 + 0.35 * 0.35;
                    covered += std::abs(0.9 * px + 0.35 * py) <= size && std::abs(-0.35 * px + 0.9 * py) <= size;
                }
            const double error = std::abs(alpha - double(covered) / (kFine * kFine));
            worst = std::max(worst, error);
            if (alpha > 0 && alpha < 1) squared += error * error, ++edges;
        }
    EXPECT_NEAR(sum, 4 * (0.9 * 0.9 + 0.35 * 0.35) * pixels * pixels, 3);
    EXPECT_LE(worst, 0.25);
    ASSERT_GT(edges, kSide);
    EXPECT_LE(std::sqrt(squared / edges), 0.08);
    // Colours are not mixed with a background that is not there.
    const double inside = channel(tile, kSide / 2, kSide / 2, 0);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            if (channel(tile, x, y, 3) > 0) {
                EXPECT_NEAR(channel(tile, x, y, 0), inside, 1) << x << ' ' << y;
            }
}

/// A sphere: only pixels next to its outline change.
TEST_P(Edges, NothingElseChanges)
{
    constexpr int kSide = 128;
    const Scene scene = makeBuiltinScene("sphere:20000", "rotation:8,8,8");
    const Camera camera = frontCamera(scene, 6, kSide, kSide);
    Stages stages(GetParam(), scene);
    ShadingOptions shading;
    const Tile smooth = draw(stages, camera, shading);
    shading.antialias = false;
    const Tile plain = draw(stages, camera, shading);
    int changed = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (same(plain, smooth, x, y)) continue;
            ++changed;
            int covered = 0;
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u) covered += plain.rgba[std::size_t(4 * ((y + v) * kSide + x + u))] != 255;
            EXPECT_TRUE(covered > 0 && covered < 9) << x << ' ' << y;
        }
    EXPECT_GT(changed, kSide);
}

/// A surface beyond all sides of the picture has no edge there.
TEST_P(Edges, ThePicturesBorderIsNone)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {9, 0, 2}, {0, 9, 1}, 3);
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    const Scene scene = makeScene(std::move(mesh));
    const Camera camera = frontCamera(scene, 6, 77, 63);
    const Tile plain = draw(scene, camera, false), smooth = draw(scene, camera, true);
    EXPECT_EQ(plain.rgba, smooth.rgba);
}

/// Light that changes evenly over a few pixels, or all over the place, is no crease.
TEST_P(Edges, ARoughSurfaceHasNone)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, 300);
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        mesh.normals[i] = glm::normalize(glm::vec3(3 * std::sin(15.0 * double(mesh.positions[i].x)), 0, 1));
    const Scene scene = makeScene(std::move(mesh));
    const Camera camera = frontCamera(scene, 6, 120, 90);
    const Tile plain = draw(scene, camera, false), smooth = draw(scene, camera, true);
    int least = 255, most = 0, changed = 0;
    for (int x = 0; x < 120; ++x) {
        least = std::min(least, int(channel(plain, x, 45, 0)));
        most = std::max(most, int(channel(plain, x, 45, 0)));
    }
    EXPECT_GT(most - least, 40) << "light and dark";
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x) changed += !same(plain, smooth, x, y);
    EXPECT_LT(changed, 90 * 120 / 10);
}

/// The columns beside the picture's border are smoothed as those of a wider picture are.
TEST_P(Edges, LieInTheFirstAndTheLastColumn)
{
    SurfaceMesh mesh;
    for (int i = -6; i <= 6; ++i)
        append(mesh, makeRectangle({0, 0.31 * i, 0}, {9, 0.7 + 0.05 * i, 0}, {-0.006, 0.08, 0}));
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    const Scene scene = makeScene(std::move(mesh));
    constexpr int kHeight = 80, kMore = 4;
    for (const int width : {64, 77, 96}) {  // Whole vectors, too.
        const Tile tile = draw(scene, frontCamera(scene, 6, width, kHeight), true, "transparent"),
                   wider = draw(scene, frontCamera(scene, 6, width + 2 * kMore, kHeight), true, "transparent");
        int edges = 0;
        for (const int x : {0, width - 1})
            for (int y = 0; y < kHeight; ++y) {
                const double alpha = channel(tile, x, y, 3);
                EXPECT_EQ(alpha, channel(wider, x + kMore, y, 3)) << width << ": " << x << ' ' << y;
                edges += alpha > 0 && alpha < 255;
            }
        EXPECT_GT(edges, 20);
    }
}

/// Also where the surface ends with one of the tiles or vectors that a backend looks at.
TEST_P(Edges, LieInTheColumnBesideTheSurface)
{
    constexpr int kWidth = 200, kHeight = 64;
    const double pixels = kHeight / (2 * 6 * std::tan(15 * std::acos(-1) / 180));
    for (const int column : {16, 32, 64, 128, kWidth - 1})
        for (const double beyond : {0.3, -0.3}) {  // Pixels.
            const double end = (column + beyond - kWidth / 2) / pixels;
            SurfaceMesh mesh = makeRectangle({end - 9, 0, 0}, {9, 0, 0}, {0, 9, 0});
            setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
            const Scene scene = makeScene(std::move(mesh));
            const Tile tile = draw(scene, frontCamera(scene, 6, kWidth, kHeight), true, "transparent");
            for (int y = 0; y < kHeight; ++y) {
                const double covered = channel(tile, column - 1, y, 3) + channel(tile, column, y, 3);
                EXPECT_NEAR(covered / 255, 1 + beyond, 0.13) << column << ' ' << y;
            }
        }
}

/// A strip that is thinner than a pixel shows in proportion to its width where any pixel's centre sees it nearby.
TEST_P(Edges, ThinStripsAreAsFaintAsTheyAreThin)
{
    constexpr int kSide = 120;
    for (const double widthPx : {0.5, 0.8, 1.5}) {
        const double pixels = kSide / (2 * 6 * std::tan(15 * std::acos(-1) / 180));
        const double half = widthPx / pixels / 2, slope = 0.31, length = std::sqrt(1 + slope * slope);
        SurfaceMesh mesh =
            makeRectangle({0.01, 0.013, 0}, {1, slope, 0}, {-slope * half / length, half / length, 0}, 1);
        setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
        const Scene scene = makeScene(std::move(mesh));
        const Tile tile = draw(scene, frontCamera(scene, 6, kSide, kSide), true, "transparent");
        double sum = 0;
        for (std::size_t i = 3; i < tile.rgba.size(); i += 4) sum += tile.rgba[i] / 255.0;
        const double area = 2 * length * pixels * widthPx;
        EXPECT_NEAR(sum / area, 1, widthPx < 1 ? 0.25 : 0.05) << widthPx;
    }
}

/// Masked scalars, corners without area, faces in the same place, a surface behind the eye: nothing throws, and alpha
/// is whole where everything around is covered.
TEST_P(Edges, UglySurfaces)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0.3, 0.4}, {-0.2, 1.5, 1.1}, 4);
    SurfaceMesh twin = makeRectangle({0, 0, 0}, {2, 0.3, 0.4}, {-0.2, 1.5, 1.1}, 3);
    for (auto& t : twin.triangles) std::swap(t[1], t[2]);
    append(mesh, twin);
    append(mesh, makeRectangle({0, 0, 5.9}, {9, 0, 0}, {0, 0, 3}));  // Seen from its edge, through the near plane.
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({0, 1, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0.2, 0); });
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        mesh.cellScalars.push_back(i % 3 == 0 ? std::nanf("") : float(i % 7));
    Scene scene = makeScene(std::move(mesh));
    scene.hasScalar = true;
    scene.scalarRange = {0, 6};
    for (const double distance : {6.0, 3.0, 0.4}) {
        const Tile tile = draw(scene, frontCamera(scene, distance, 80, 60), true, "transparent");
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x)
                if (channel(tile, x, y, 3) == 0) {
                    EXPECT_EQ(channel(tile, x, y, 0), channel(tile, 0, 0, 0));
                }
    }
}

}  // namespace
}  // namespace aeolic
