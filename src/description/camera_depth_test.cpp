#include <gtest/gtest.h>

#include <cmath>

#include "description/camera.h"
#include "description/camera_testing.h"

namespace aeolic {
namespace {

using namespace camera_testing;

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

/// From within a large scene the viewer looks at the focal point. The scene's centre says nothing about that.
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

TEST(Camera, DepthRangeIsPositiveInsideAndBehindTheSurface)
{
    for (const double y : {-2.0, 0.0, 2.0, 10.0, 1e6}) {
        const Camera camera = makeCamera(absolute({1, y, 5}, {1, y + 1, 5}), kBox, kRadius, 400, 300);
        EXPECT_GT(camera.nearDepth, 0) << y;
        EXPECT_GT(camera.farDepth, camera.nearDepth) << y;
    }
}

/// A surface that moves out of the fitted sphere is neither cut off nor does it move the camera.
TEST(Camera, ReachMovesTheDepthsAndNothingElse)
{
    const Bounds bounds{{-1, -1, -1}, {1, 1, 1}}, moved{{-2.5, -3, -1}, {2, 3, 2}};
    CameraOptions alongY;
    alongY.azimuth = alongY.elevation = 0;
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
    options.azimuth = options.elevation = 0;
    const Camera front = makeCamera(options, plate, radius, 100, 100);
    const double distance = glm::length(front.positionWorld), room = 1e-3 * radius;
    EXPECT_NEAR(front.nearDepth, distance - 0.1 - room, 1e-9);
    EXPECT_NEAR(front.farDepth, distance + 0.1 + room, 1e-9);
    options.azimuth = 90;
    const Camera side = makeCamera(options, plate, radius, 100, 100);
    EXPECT_NEAR(side.nearDepth, distance - 3 - room, 1e-9);
    options.azimuth = 45;  // The box's corner is seen first.
    const Camera corner = makeCamera(options, plate, radius, 100, 100);
    EXPECT_NEAR(corner.nearDepth, distance - 3.1 * std::sqrt(0.5) - room, 1e-9);
}

}  // namespace
}  // namespace aeolic
