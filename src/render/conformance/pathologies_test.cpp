#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/reference.h"
#include "render_testing.h"

/// Views and surfaces that are legal and strange.
namespace aeolic {
namespace {

using namespace testkit;

class Pathologies : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Pathologies, allBackends, backendName);

const VectorAt kAlongX = [](const glm::dvec3&) { return glm::vec3(1, 0, 0); };

int covered(const GBuffer& buffer)
{
    int count = 0;
    for (int y = buffer.valid().y0; y < buffer.valid().y1; ++y)
        for (int x = buffer.valid().x0; x < buffer.valid().x1; ++x) count += buffer.invDepth.at(x, y) > 0;
    return count;
}

/// Coverage and depth as rays find them, but for pixel centres within rounding of an edge; all LIC values finite.
void expectReference(Stages& stages, const Camera& camera, int allowedCoverage, double depthTolerance = 1e-4)
{
    const LicOptions lic = directLic(8);
    const GBuffer& buffer = stages.project(camera, lic);
    const reference::PixelImage expected = reference::project(stages.view, stages.scene, stages.noise);
    int differ = 0, depthsOff = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const double a = expected.at(x, y).invDepth, b = double(buffer.invDepth.at(x, y));
            differ += (a > 0) != (b > 0);
            depthsOff += a > 0 && b > 0 && std::abs(a - b) > depthTolerance * a;
        }
    EXPECT_LE(differ, allowedCoverage);
    EXPECT_LE(depthsOff, allowedCoverage);
    const Image<float>& found = stages.convolve(lic);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) ASSERT_TRUE(std::isfinite(found.at(x, y))) << x << "," << y;
}

Camera cameraFrom(const Scene& scene, const Vec3& position, const Vec3& focal, int width, int height, double fovDeg)
{
    CameraOptions options;
    options.position = position;
    options.focal = focal;
    options.fov = fovDeg;
    return fitCamera(scene, options, width, height);
}

TEST_P(Pathologies, SurfaceBehindTheCamera)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:2000", "abc:8,8,8"));
    const Camera camera = cameraFrom(stages.scene, {0, -20, 0}, {0, -30, 0}, 60, 50, 60);
    const LicOptions lic = directLic(8);
    const GBuffer& buffer = stages.project(camera, lic);
    EXPECT_EQ(covered(buffer), 0);
    const Image<float>& found = stages.convolve(lic);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 60; ++x) ASSERT_EQ(found.at(x, y), 0);
}

/// After a full picture the images' memory is not fresh: nothing of it may show through.
TEST_P(Pathologies, EmptyViewAfterAFullOne)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:800", "abc:8,8,8"));
    const LicOptions lic = directLic(8);
    CameraOptions inside;
    inside.zoom = 5;
    EXPECT_EQ(covered(stages.project(fitCamera(stages.scene, inside, 60, 50), lic)), 60 * 50);
    stages.convolve(lic);
    const GBuffer& buffer = stages.project(cameraFrom(stages.scene, {0, -20, 0}, {0, -30, 0}, 60, 50, 60), lic);
    EXPECT_EQ(covered(buffer), 0);
    const Image<float>& found = stages.convolve(lic);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 60; ++x) ASSERT_EQ(found.at(x, y), 0);
}

TEST_P(Pathologies, CameraInsideTheSurface)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:2000", "abc:8,8,8"));
    for (const Vec3& position : {Vec3{0, 0, 0}, Vec3{0.6, 0.1, -0.3}, Vec3{0, 0, 0.995}}) {
        const Camera camera = cameraFrom(stages.scene, position, {0.7, 0.9, 0.1}, 90, 70, 100);
        expectReference(stages, camera, 1);
    }
}

/// A floor that begins behind the camera: its triangles are cut at the near plane.
TEST_P(Pathologies, TrianglesThroughTheNearPlane)
{
    SurfaceMesh mesh = makeRectangle({0, 0, -0.5}, {10, 0, 0}, {0, 10, 0}, 3);
    setPointVectors(mesh, kAlongX);
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    for (const Vec3& up : {Vec3{0, 0, 1}, Vec3{0.6, 0, 0.8}}) {
        CameraOptions options;
        options.position = Vec3{0.3, -2, 0};
        options.focal = Vec3{0, 8, 0};
        options.up = up;
        options.fov = 110;
        const Camera camera = fitCamera(stages.scene, options, 121, 91);
        expectReference(stages, camera, 12);
        EXPECT_GT(covered(*stages.buffer), 3000);
    }
}

/// The near plane itself shows as an edge where the surface comes closer than the nearest depth.
TEST_P(Pathologies, NearPlaneCutsExactly)
{
    SurfaceMesh mesh = makeRectangle({0, 0, -0.5}, {10, 0, 0}, {0, 10, 0}, 3);
    setPointVectors(mesh, kAlongX);
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    Camera camera = cameraFrom(stages.scene, {0.3, -2, 0}, {0, 8, 0}, 121, 91, 110);
    camera.nearDepth = 1.5;
    expectReference(stages, camera, 6);
    EXPECT_GT(covered(*stages.buffer), 1000);
    camera.nearDepth = 0.01;
    camera.farDepth = 3;
    expectReference(stages, camera, 6);
    EXPECT_GT(covered(*stages.buffer), 500);
}

/// Corners far beyond the guard band of exact arithmetic: no pixel is lost or gained. Depths are as good as single
/// precision is at the corners: beyond a million times the view nothing is left of them.
TEST_P(Pathologies, HugeTrianglesFarOutsideTheImage)
{
    for (const double half : {1e3, 1e5, 1e7}) {
        SurfaceMesh mesh = makeRectangle({0, 0, -1}, {half, 0.1 * half, 0}, {-0.2 * half, half, 0});
        setPointVectors(mesh, kAlongX);
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        CameraOptions options;
        options.position = Vec3{0.3, -0.1, 0};
        options.focal = Vec3{0.5, 1, -0.4};
        options.fov = 60;
        Camera camera = fitCamera(stages.scene, options, 120, 90);
        camera.nearDepth = 0.01;
        SCOPED_TRACE(half);
        expectReference(stages, camera, 6, half < 1e6 ? 1e-6 * half : 1e6);
        EXPECT_GT(covered(*stages.buffer), 5000);
    }
}

/// Triangles without area should be gone before; should one survive, it does not show.
TEST_P(Pathologies, DegenerateTrianglesDoNotShow)
{
    SurfaceMesh clean = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
    setPointVectors(clean, [](const glm::dvec3& p) { return glm::vec3(1, p.x, 0); });
    SurfaceMesh dirty = clean;
    dirty.triangles.push_back({0, 0, 4});  // A point twice, all on a line, all the same.
    dirty.triangles.push_back({0, 4, 8});
    dirty.triangles.push_back({4, 4, 4});
    Stages a(GetParam(), makeScene(std::move(clean))), b(GetParam(), makeScene(std::move(dirty)));
    const LicOptions lic = directLic(20);
    const GBuffer &bufferA = a.project(frontCamera(a.scene, 4, 60, 60), lic),
                  &bufferB = b.project(frontCamera(b.scene, 4, 60, 60), lic);
    const Image<float>&foundA = a.convolve(lic), &foundB = b.convolve(lic);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) {
            ASSERT_EQ(bufferA.invDepth.at(x, y), bufferB.invDepth.at(x, y)) << x << "," << y;
            ASSERT_EQ(bufferA.flow.at(x, y), bufferB.flow.at(x, y)) << x << "," << y;
            ASSERT_EQ(foundA.at(x, y), foundB.at(x, y)) << x << "," << y;
        }
}

TEST_P(Pathologies, OneTriangleOnOnePixel)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0});
    mesh.triangles.resize(1);
    mesh.triangles[0] = {0, 1, 2};  // Its own corner of the square, over the image's centre.
    for (glm::vec3& p : mesh.positions) p += glm::vec3(0.5e-3f, 0.5e-3f, 0);
    setPointVectors(mesh, kAlongX);
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    const LicOptions lic = directLic(20);
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 2, 41, 41), lic);
    EXPECT_EQ(covered(buffer), 1);
    EXPECT_GT(buffer.invDepth.at(20, 20), 0);
    EXPECT_EQ(buffer.links.at(20, 20), 0);
    const Image<float>& found = stages.convolve(lic);
    EXPECT_TRUE(std::isfinite(found.at(20, 20)));
    for (int y = 0; y < 41; ++y)
        for (int x = 0; x < 41; ++x) EXPECT_TRUE(found.at(x, y) == 0 || (x == 20 && y == 20)) << x << "," << y;
}

TEST_P(Pathologies, ImageOfOnePixel)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:800", "abc:8,8,8"));
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        LicOptions lic = directLic(128);
        lic.method = method;
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 1, 1), lic);
        EXPECT_EQ(covered(buffer), 1);
        EXPECT_EQ(buffer.links.at(0, 0), 0);
        EXPECT_TRUE(std::isfinite(stages.convolve(lic).at(0, 0)));
    }
}

/// Data in metres far from its origin, as in a geographic projection: the mesh keeps an origin of its own.
TEST_P(Pathologies, SurfaceFarFromTheOrigin)
{
    const glm::dvec3 far(4.5e6, -3e5, 120);
    const auto lic = directLic(16);
    std::vector<double> values[2];
    for (const bool moved : {false, true}) {
        SurfaceMesh mesh = makeBuiltinScene("torus:2000", "uniform:2,2,2").surface;
        if (moved) mesh.originWorld += far;
        const glm::dvec3 origin = mesh.originWorld;
        setPointVectors(mesh, [&](const glm::dvec3& p) { return glm::vec3(-(p - origin).y, (p - origin).x, 0.2); });
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 90, 70), lic);
        const Image<float>& found = stages.convolve(lic);
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 90; ++x)
                values[moved].push_back(buffer.flow.at(x, y) != 0 ? double(found.at(x, y)) : -100.0);
    }
    EXPECT_GT(correlation(values[0], values[1]), 0.999);
}

}  // namespace
}  // namespace aeolic
