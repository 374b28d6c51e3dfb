#include "description/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "aeolic/error.h"
#include "description/camera_testing.h"

namespace aeolic {
namespace {

using namespace camera_testing;

Camera relative(double azimuthDeg, double elevationDeg, double rollDeg = 0, int width = 400, int height = 300)
{
    CameraOptions options;
    options.azimuth = azimuthDeg;
    options.elevation = elevationDeg;
    options.roll = rollDeg;
    return makeCamera(options, kBox, kRadius, width, height);
}

std::string errorOf(const CameraOptions& options)
{
    try {
        makeCamera(options, kBox, kRadius, 400, 300);
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

/// The sphere's outline touches the image's narrower side but for the margin; all of it lies between near and far.
TEST(Camera, FitShowsTheWholeSphereAndLittleElse)
{
    for (const double fovDeg : {1.0, 30.0, 100.0})
        for (const auto& [width, height] :
             {std::pair(400, 300), std::pair(300, 400), std::pair(64, 64), std::pair(1, 800)}) {
            CameraOptions options;
            options.fov = fovDeg;
            const Camera camera = makeCamera(options, kBox, kRadius, width, height);
            double widest = 0;  // As a part of the half image, on either side.
            for (int i = 0; i <= 100; ++i)
                for (int j = 0; j < 200; ++j) {
                    const double polar = std::numbers::pi * i / 100, turn = std::numbers::pi * j / 100;
                    const glm::dvec3 outward(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                                             std::cos(polar));
                    const glm::dvec3 p = kCenter + kRadius * outward - camera.positionWorld;
                    const double depth = glm::dot(p, camera.forward);
                    ASSERT_GT(depth, camera.nearDepth);
                    ASSERT_LT(depth, camera.farDepth);
                    widest =
                        std::max({widest, std::abs(camera.focalPx * glm::dot(p, camera.right) / depth) / (0.5 * width),
                                  std::abs(camera.focalPx * glm::dot(p, camera.up) / depth) / (0.5 * height)});
                }
            EXPECT_LE(widest, 1.0) << fovDeg << " degrees, " << width << "x" << height;
            EXPECT_GE(widest, 0.9) << fovDeg << " degrees, " << width << "x" << height;
        }
}

TEST(Camera, AzimuthZeroLooksAlongYWithZUp)
{
    const Camera camera = relative(0, 0);
    expectNear(camera.forward, {0, 1, 0});
    expectNear(camera.right, {1, 0, 0});
    expectNear(camera.up, {0, 0, 1});
    expectNear(camera.positionWorld, kCenter - camera.focalDistance * camera.forward, 1e-9);
}

TEST(Camera, AzimuthWalksTowardsPlusX)
{
    expectNear(relative(90, 0).forward, {-1, 0, 0});
}

TEST(Camera, ElevationLooksDown)
{
    const double half = std::sqrt(0.5);
    expectNear(relative(0, 45).forward, {0, half, -half});
    expectNear(relative(0, 90).forward, {0, 0, -1});
    expectNear(relative(0, 90).up, {0, 1, 0});
}

TEST(Camera, RollTurnsTheCameraAboutItsView)
{
    const Camera level = relative(30, 20), rolled = relative(30, 20, 90);
    expectNear(rolled.forward, level.forward);
    expectNear(rolled.right, level.up);
    expectNear(rolled.up, -level.right);
}

TEST(Camera, AxesAreOrthonormalFromEverywhere)
{
    for (int azimuth = -720; azimuth <= 720; azimuth += 37)
        for (int elevation = -180; elevation <= 180; elevation += 15) {
            const Camera c = relative(azimuth, elevation, 0.3 * azimuth);
            EXPECT_NEAR(glm::length(c.forward), 1, 1e-12);
            EXPECT_NEAR(glm::length(c.right), 1, 1e-12);
            EXPECT_NEAR(glm::dot(c.forward, c.right), 0, 1e-12);
            expectNear(glm::cross(c.right, c.forward), c.up);
        }
}

TEST(Camera, OrbitKeepsItsDistance)
{
    const Camera start = relative(0, 20);
    for (int azimuth = 0; azimuth < 360; azimuth += 7) {
        const Camera c = relative(azimuth, 20);
        EXPECT_NEAR(glm::length(c.positionWorld - kCenter), start.focalDistance, 1e-12);
        EXPECT_NEAR(c.nearDepth, start.nearDepth, 1e-12);
        EXPECT_NEAR(c.farDepth, start.farDepth, 1e-12);
        EXPECT_DOUBLE_EQ(c.focalPx, start.focalPx);
    }
}

/// At the poles an "up" fixed in the world would flip the image by half a turn.
TEST(Camera, GoesOverThePolesWithoutAFlip)
{
    for (const double pole : {90.0, -90.0, 270.0}) {
        Camera before = relative(30, pole - 2);
        for (double elevation = pole - 2; elevation <= pole + 2; elevation += 0.25) {
            const Camera c = relative(30, elevation);
            EXPECT_GT(glm::dot(c.up, before.up), 0.9999) << elevation;
            EXPECT_GT(glm::dot(c.right, before.right), 0.9999) << elevation;
            before = c;
        }
    }
}

TEST(Camera, AFocalPointMovesTheRelativeViewWithIt)
{
    CameraOptions options;
    const Camera centered = makeCamera(options, kBox, kRadius, 400, 300);
    options.focal = Vec3{2, 1, 5};
    const Camera moved = makeCamera(options, kBox, kRadius, 400, 300);
    expectNear(moved.positionWorld - centered.positionWorld, {1, 1, 0});
    expectNear(moved.forward, centered.forward);
}

TEST(Camera, AbsoluteViewIsTakenAsGiven)
{
    CameraOptions options = absolute({1, -10, 5}, {1, -4, 5});
    options.up = Vec3{1, 3, 0};  // Only the part of up that is across the view counts.
    options.fov = 90;
    const Camera camera = makeCamera(options, kBox, kRadius, 400, 300);
    expectNear(camera.positionWorld, {1, -10, 5});
    expectNear(camera.forward, {0, 1, 0});
    expectNear(camera.up, {1, 0, 0});
    EXPECT_DOUBLE_EQ(camera.focalDistance, 6);
    EXPECT_NEAR(camera.focalPx, 150, 1e-9);
    EXPECT_NEAR(camera.pixelSizeAtBody(), 10 / 150.0, 1e-12);
    EXPECT_NEAR(camera.farDepth, 10 + 2, 0.01 * kRadius);
    EXPECT_NEAR(camera.nearDepth, 10 - 2, 0.01 * kRadius);
}

TEST(Camera, AbsoluteViewIgnoresTheAngles)
{
    CameraOptions options = absolute({1, -10, 5}, {1, 0, 5});
    const Camera plain = makeCamera(options, kBox, kRadius, 400, 300);
    options.azimuth = 77;
    options.elevation = -33;
    options.roll = 45;
    options.zoom = 3;
    const Camera angled = makeCamera(options, kBox, kRadius, 400, 300);
    expectNear(angled.positionWorld, plain.positionWorld);
    expectNear(angled.forward, plain.forward);
    expectNear(angled.up, plain.up);
}

TEST(Camera, LooksDownTheZAxisWithoutAnUp)
{
    const Camera camera = makeCamera(absolute({1, 0, 20}, {1, 0, 5}), kBox, kRadius, 400, 300);
    expectNear(camera.forward, {0, 0, -1});
    expectNear(camera.up, {0, 1, 0});
}

TEST(Camera, ASurfaceWithoutExtentStillHasAView)
{
    const Bounds point{{1, 2, 3}, {1, 2, 3}};
    const Camera camera = makeCamera({}, point, 0, 40, 30);
    EXPECT_GT(camera.focalDistance, 0);
    EXPECT_GT(camera.nearDepth, 0);
    expectNear(camera.positionWorld + camera.focalDistance * camera.forward, {1, 2, 3}, 1e-9);
}

TEST(Camera, PositionOnTheFocalPointIsAnError)
{
    EXPECT_EQ(errorOf(absolute({1, 2, 3}, {1, 2, 3})),
              "--camera: position and focal point coincide; expected two different points");
}

TEST(Camera, UpAlongTheViewOrZeroIsAnError)
{
    CameraOptions options = absolute({0, 0, 0}, {0, 3, 0});
    for (const Vec3& up : {Vec3{0, 1, 0}, Vec3{0, -5, 0}, Vec3{0, 0, 0}}) {
        options.up = up;
        EXPECT_EQ(errorOf(options), "--camera: up is zero or parallel to the view; expected a direction across it");
    }
}

TEST(Orbit, TurnsAnAbsoluteViewAboutItsFocalPoint)
{
    CameraOptions view;
    view.position = Vec3{1, -4, 2};
    view.focal = Vec3{1, 0, 0};
    view.up = Vec3{0, 0, 1};
    const CameraOptions quarter = orbited(view, 90, {});
    ASSERT_TRUE(quarter.position);
    const Vec3 expected{5, 0, 2};  // Counterclockwise from above: from -y to +x.
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR((*quarter.position)[c], expected[c], 1e-12);
}

TEST(Orbit, TurnsARelativeViewTheSameWay)
{
    Bounds bounds;
    bounds.add({-1, -1, -1});
    bounds.add({1, 1, 1});
    CameraOptions relative;
    const Camera start = makeCamera(relative, bounds, 1, 100, 100),
                 turned = makeCamera(orbited(relative, 40, bounds), bounds, 1, 100, 100);
    CameraOptions absolute;
    absolute.position = Vec3{start.positionWorld.x, start.positionWorld.y, start.positionWorld.z};
    const CameraOptions other = orbited(absolute, 40, bounds);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*other.position)[std::size_t(c)], turned.positionWorld[c], 1e-12);
}

TEST(Camera, AnAnimationInTimeDoesNotTurnUnlessAskedTo)
{
    SceneDescription scene;
    EXPECT_EQ(orbitDegOf(scene), 360);
    scene.lic.flow = FlowMotion::loop;
    EXPECT_EQ(orbitDegOf(scene), 0);
    scene.lic.flow = FlowMotion::off;
    scene.time.range = {0, 1};
    EXPECT_EQ(orbitDegOf(scene), 0);
    scene.output.orbit = 90;
    EXPECT_EQ(orbitDegOf(scene), 90);
}

glm::dvec3 outwardOf(const CameraOptions& options)
{
    return -makeCamera(options, kBox, kRadius, 400, 300).forward;
}

TEST(Camera, APlaneThatTheDefaultViewSeesFromItsEdgeIsLookedAtStraight)
{
    const CameraOptions usual;
    const glm::dvec3 outward = outwardOf(usual);
    for (const glm::dvec3& across : {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(1, 2, 3)}) {
        const glm::dvec3 edge = glm::normalize(glm::cross(outward, across));
        for (const glm::dvec3& normal : {edge, -edge}) {
            const double part = glm::dot(outwardOf(offEdge(usual, normal)), normal);
            EXPECT_NEAR(std::abs(part), 1, 1e-12);
        }
        const glm::dvec3 nearly = glm::normalize(edge + 0.2 * outward);  // 11 degrees.
        expectNear(outwardOf(offEdge(usual, nearly)), nearly);
        expectNear(outwardOf(offEdge(usual, -nearly)), nearly);
    }
}

TEST(Camera, OtherPlanesAndOtherViewsStayAsTheyAre)
{
    for (const glm::dvec3& normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
        EXPECT_EQ(offEdge({}, normal).azimuth, CameraOptions().azimuth) << "the default view shows it";
    CameraOptions chosen;
    chosen.azimuth = 31;
    const glm::dvec3 edge = glm::normalize(glm::cross(outwardOf(chosen), glm::dvec3(0, 0, 1)));
    EXPECT_EQ(offEdge(chosen, edge).azimuth, 31);
    EXPECT_EQ(offEdge(absolute({0, 0, 9}, {0, 0, 0}), {1, 0, 0}).elevation, CameraOptions().elevation);
}

}  // namespace
}  // namespace aeolic
