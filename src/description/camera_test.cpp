#include "description/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "aeolic/error.h"

namespace aeolic {
namespace {

const Bounds kBox{{-1, -2, 3}, {3, 2, 7}};  // Centre (1, 0, 5).
const glm::dvec3 kCenter(1, 0, 5);
constexpr double kRadius = 2.5;

Camera relative(double azimuthDeg, double elevationDeg, double rollDeg = 0, int width = 400, int height = 300)
{
    CameraOptions options;
    options.azimuthDeg = azimuthDeg;
    options.elevationDeg = elevationDeg;
    options.rollDeg = rollDeg;
    return makeCamera(options, kBox, kRadius, width, height);
}

CameraOptions absolute(const Vec3& position, const Vec3& focal)
{
    CameraOptions options;
    options.position = position;
    options.focal = focal;
    return options;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "component " << c;
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
            options.fovDeg = fovDeg;
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

TEST(Camera, SmallZoomsDivideTheDistanceAndKeepTheField)
{
    CameraOptions options;
    const Camera whole = makeCamera(options, kBox, kRadius, 400, 300);
    for (const double zoom : {0.1, 1.5, 2.0, 2.5}) {
        options.zoom = zoom;
        const Camera camera = makeCamera(options, kBox, kRadius, 400, 300);
        EXPECT_NEAR(camera.focalDistance, whole.focalDistance / zoom, 1e-12);
        EXPECT_EQ(camera.focalPx, whole.focalPx);
        EXPECT_EQ(camera.fovDeg, options.fovDeg);
    }
}

/// A zoom shows an N-th of the surface N times as large, and never from within it.
TEST(Camera, LargeZoomsStayOutsideAndScaleTheFocalPoint)
{
    for (const double fovDeg : {1.0, 30.0, 120.0, 170.0})
        for (const std::optional<Vec3> focal : {std::optional<Vec3>{}, std::optional<Vec3>{{-1, -2, 4.5}}})
            for (const double azimuth : {30.0, 200.0}) {
                CameraOptions options;
                options.fovDeg = fovDeg;
                options.focal = focal;
                options.azimuthDeg = azimuth;
                const Camera whole = makeCamera(options, kBox, kRadius, 400, 300);
                const double scale = whole.focalPx / whole.focalDistance;
                const double away = std::min(1.5 * kRadius, glm::length(whole.positionWorld - kCenter));
                for (const double zoom : {1.01, 2.0, 2.67, 2.69, 12.0, 400.0, 1e6}) {
                    options.zoom = zoom;
                    const Camera camera = makeCamera(options, kBox, kRadius, 400, 300);
                    SCOPED_TRACE(testing::Message() << fovDeg << " degrees, zoom " << zoom);
                    EXPECT_NEAR(camera.focalPx / camera.focalDistance / (zoom * scale), 1, 1e-9);
                    EXPECT_GE(glm::length(camera.positionWorld - kCenter), away - 1e-9);
                    expectNear(camera.forward, whole.forward, 1e-9);
                    const double corner = std::hypot(200, 150) / camera.focalPx;
                    EXPECT_GT(camera.nearDepth * std::hypot(1, corner), 0.99 * (away - kRadius) - 1e-2);
                }
            }
}

/// A focal point far in front of a surface is no way into it: the eye comes as near to it as asked.
TEST(Camera, AZoomToAPointBesideTheSurfaceComesCloser)
{
    CameraOptions options;
    options.focal = Vec3{20, 0, 5};
    const double whole = makeCamera(options, kBox, kRadius, 400, 300).focalDistance;
    options.zoom = 50;
    const Camera camera = makeCamera(options, kBox, kRadius, 400, 300);
    EXPECT_NEAR(camera.focalDistance, whole / 50, 1e-9);
    EXPECT_EQ(camera.fovDeg, options.fovDeg);
}

/// What a page sends is an absolute view.
TEST(Camera, AZoomedViewIsTheAbsoluteOneWithItsNumbers)
{
    CameraOptions options;
    options.zoom = 50;
    const Camera zoomed = makeCamera(options, kBox, kRadius, 400, 300);
    const glm::dvec3 p = zoomed.positionWorld, f = p + zoomed.focalDistance * zoomed.forward;
    CameraOptions same = absolute({p.x, p.y, p.z}, {f.x, f.y, f.z});
    same.up = Vec3{zoomed.up.x, zoomed.up.y, zoomed.up.z};
    same.fovDeg = zoomed.fovDeg;
    const Camera camera = makeCamera(same, kBox, kRadius, 400, 300);
    EXPECT_EQ(camera.focalPx, zoomed.focalPx);
    EXPECT_NEAR(camera.bodyDepth, zoomed.bodyDepth, 1e-12);
    expectNear(camera.forward, zoomed.forward);
    expectNear(camera.right, zoomed.right);
}

TEST(Camera, APlaneLookedAtStraightOnIsZoomedFromOutsideToo)
{
    const Bounds plane{{-1, -1, 0}, {1, 1, 0}};
    const double radius = std::sqrt(2.0);
    CameraOptions options;
    for (const double zoom : {1.0, 1.5, 12.0, 400.0, 1e5}) {
        options.zoom = zoom;
        const Camera camera = makeCamera(straightAt(options, plane, 300, 300), plane, radius, 300, 300);
        EXPECT_NEAR(camera.focalPx / camera.focalDistance, zoom * 150, 1e-9 * zoom * 150);
        EXPECT_GT(camera.focalDistance, 1.49 * radius);
        EXPECT_NEAR(camera.bodyDepth, camera.focalDistance, 1e-12);
    }
}

/// To most people a focal point is a direction.
TEST(Camera, TheBodysDepthDoesNotDependOnWhereOnTheLineTheFocalPointIs)
{
    const glm::dvec3 eye(1, -10, 5), to(1, 0.5, 5.3);
    const auto depthAt = [&](double part) {
        const glm::dvec3 f = eye + part * (to - eye);
        return makeCamera(absolute({eye.x, eye.y, eye.z}, {f.x, f.y, f.z}), kBox, kRadius, 400, 300).bodyDepth;
    };
    const double expected = 10 * 10.5 / std::hypot(10.5, 0.3);  // The centre's depth.
    for (const double part : {1e-6, 0.1, 1.0, 3.0, 1e6}) EXPECT_NEAR(depthAt(part), expected, 1e-6) << part;
}

TEST(Camera, TheBodysDepthIsTheFocalPointsInAViewOfTheWhole)
{
    for (const double zoom : {0.2, 1.0, 2.0, 5.0, 100.0}) {
        CameraOptions options;
        options.zoom = zoom;
        const Camera camera = makeCamera(options, kBox, kRadius, 400, 300);
        EXPECT_EQ(camera.bodyDepth, camera.focalDistance) << zoom;
    }
}

/// From within a large scene the focal point says what is looked at, and its centre says nothing.
TEST(Camera, TheBodysDepthIsTheFocalPointsWithinTheSurface)
{
    EXPECT_NEAR(makeCamera(absolute({1, 0, 5}, {1, 0.5, 5}), kBox, kRadius, 400, 300).bodyDepth, 0.5, 1e-12);
    EXPECT_NEAR(makeCamera(absolute({1, 1, 5}, {1, 2, 5}), kBox, kRadius, 400, 300).bodyDepth, 1, 1e-12);
    for (const double ahead : {1e-9, 1e9}) {  // Still a part of the surface's size.
        const double depth = makeCamera(absolute({1, 0, 5}, {1, ahead, 5}), kBox, kRadius, 400, 300).bodyDepth;
        EXPECT_GE(depth, kRadius / 64);
        EXPECT_LE(depth, kRadius);
    }
}

/// An eye that comes closer, or a view that turns, has no jump in its streaks.
TEST(Camera, TheBodysDepthNeverJumps)
{
    double before = 0;
    for (double y = -12; y <= 12; y += 0.01) {
        const double depth =
            makeCamera(absolute({1.2, y, 5.1}, {1.2, y + 0.3, 5.1}), kBox, kRadius, 400, 300).bodyDepth;
        EXPECT_GT(depth, 0);
        EXPECT_NEAR(depth, before > 0 ? before : depth, 0.03) << y;
        before = depth;
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
    options.fovDeg = 90;
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
    options.azimuthDeg = 77;
    options.elevationDeg = -33;
    options.rollDeg = 45;
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

TEST(Camera, DepthRangeIsPositiveInsideAndBehindTheSurface)
{
    for (const double y : {-2.0, 0.0, 2.0, 10.0, 1e6}) {
        const Camera camera = makeCamera(absolute({1, y, 5}, {1, y + 1, 5}), kBox, kRadius, 400, 300);
        EXPECT_GT(camera.nearDepth, 0) << y;
        EXPECT_GT(camera.farDepth, camera.nearDepth) << y;
    }
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

/// A surface that moves out of the fitted sphere is neither cut off nor does it move the camera.
TEST(Camera, ReachMovesTheDepthsAndNothingElse)
{
    const Bounds bounds{{-1, -1, -1}, {1, 1, 1}}, moved{{-2.5, -3, -1}, {2, 3, 2}};
    CameraOptions alongY;
    alongY.azimuthDeg = alongY.elevationDeg = 0;
    const Bounds box{{-0.5, -0.4, -0.5}, {0.5, 0.3, 0.5}};
    const Camera still = makeCamera(alongY, bounds, 1, 100, 100),
                 moving = makeCamera(alongY, bounds, 1, 100, 100, {moved, 2.5}),
                 within = makeCamera(alongY, bounds, 1, 100, 100, {box, 0.7});
    EXPECT_EQ(moving.positionWorld, still.positionWorld);
    EXPECT_EQ(moving.focalPx, still.focalPx);
    const double distance = glm::length(still.positionWorld);
    EXPECT_NEAR(moving.nearDepth, distance - 1.001 * 2.5, 1e-9);
    EXPECT_NEAR(moving.farDepth, distance + 1.001 * 2.5, 1e-9);
    EXPECT_NEAR(within.nearDepth, distance - 0.4 - 0.0007, 1e-9);
    EXPECT_NEAR(within.farDepth, distance + 0.3 + 0.0007, 1e-9);
}

/// Depths follow the box where it is tighter than the sphere: flat and long surfaces are far from their sphere's front.
TEST(Camera, DepthsAreThoseOfTheBoxWhereItsSidesAreNarrow)
{
    const Bounds plate{{-3, -0.1, -1}, {3, 0.1, 1}};
    const double radius = std::sqrt(9 + 0.01 + 1);
    CameraOptions options;
    options.azimuthDeg = options.elevationDeg = 0;
    const Camera front = makeCamera(options, plate, radius, 100, 100);
    const double distance = glm::length(front.positionWorld), room = 1e-3 * radius;
    EXPECT_NEAR(front.nearDepth, distance - 0.1 - room, 1e-9);
    EXPECT_NEAR(front.farDepth, distance + 0.1 + room, 1e-9);
    options.azimuthDeg = 90;
    const Camera side = makeCamera(options, plate, radius, 100, 100);
    EXPECT_NEAR(side.nearDepth, distance - 3 - room, 1e-9);
    options.azimuthDeg = 45;  // The box's corner is seen first.
    const Camera corner = makeCamera(options, plate, radius, 100, 100);
    EXPECT_NEAR(corner.nearDepth, distance - 3.1 * std::sqrt(0.5) - room, 1e-9);
}

TEST(Camera, AnAnimationInTimeDoesNotTurnUnlessAskedTo)
{
    SceneDescription scene;
    EXPECT_EQ(orbitDegOf(scene), 360);
    scene.time.range = {0, 1};
    EXPECT_EQ(orbitDegOf(scene), 0);
    scene.output.orbitDeg = 90;
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
        EXPECT_EQ(offEdge({}, normal).azimuthDeg, CameraOptions().azimuthDeg) << "the default view shows it";
    CameraOptions chosen;
    chosen.azimuthDeg = 31;
    const glm::dvec3 edge = glm::normalize(glm::cross(outwardOf(chosen), glm::dvec3(0, 0, 1)));
    EXPECT_EQ(offEdge(chosen, edge).azimuthDeg, 31);
    EXPECT_EQ(offEdge(absolute({0, 0, 9}, {0, 0, 0}), {1, 0, 0}).elevationDeg, CameraOptions().elevationDeg);
}

}  // namespace
}  // namespace aeolic
