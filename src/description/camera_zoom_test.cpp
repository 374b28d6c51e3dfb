#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "description/camera.h"
#include "description/camera_testing.h"
#include "description/validate.h"

namespace aeolic {
namespace {

using namespace camera_testing;

TEST(Camera, SmallZoomsDivideTheDistanceAndKeepTheField)
{
    CameraOptions options;
    const Camera whole = makeCamera(options, kBox, kRadius, 400, 300);
    for (const double zoom : {0.1, 1.5, 2.0, 2.5}) {
        options.zoom = zoom;
        const Camera camera = makeCamera(options, kBox, kRadius, 400, 300);
        EXPECT_NEAR(camera.focalDistance, whole.focalDistance / zoom, 1e-12);
        EXPECT_EQ(camera.focalPx, whole.focalPx);
        EXPECT_EQ(camera.fovDeg, options.fov);
    }
}

/// A zoom shows an N-th of the surface N times as large, and never from within it.
TEST(Camera, LargeZoomsStayOutsideAndScaleTheFocalPoint)
{
    for (const double fovDeg : {1.0, 30.0, 120.0, 170.0})
        for (const std::optional<Vec3> focal : {std::optional<Vec3>{}, std::optional<Vec3>{{-1, -2, 4.5}}})
            for (const double azimuth : {30.0, 200.0}) {
                CameraOptions options;
                options.fov = fovDeg;
                options.focal = focal;
                options.azimuth = azimuth;
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
    EXPECT_EQ(camera.fovDeg, options.fov);
}

const Bounds kUnitBox{{-1, -1, -1}, {1, 1, 1}};  // About a sphere of radius 1.

/// Where a view along +y, zoomed so about this focal point, has its eye.
glm::dvec3 eyeOf(const glm::dvec3& focal, double zoom)
{
    CameraOptions options;
    options.azimuth = options.elevation = 0;
    options.focal = Vec3{focal.x, focal.y, focal.z};
    options.zoom = zoom;
    return makeCamera(options, kUnitBox, 1, 300, 300).positionWorld;
}

TEST(Camera, AZoomToAPointBehindTheBodyStaysBeforeIt)
{
    CameraOptions options;
    options.azimuth = options.elevation = 0;
    options.focal = Vec3{0, 2, 0};
    const Camera whole = makeCamera(options, kUnitBox, 1, 300, 300);
    expectNear(whole.positionWorld, {0, 2 - 1.04 / std::sin(std::numbers::pi / 12), 0}, 1e-9);
    for (const double zoom : {1.2, 2.0, 50.0, 1e6}) {
        options.zoom = zoom;
        const Camera camera = makeCamera(options, kUnitBox, 1, 300, 300);
        expectNear(camera.positionWorld, {0, -1.5, 0}, 1e-9);
        EXPECT_NEAR(camera.focalPx / camera.focalDistance * whole.focalDistance / whole.focalPx / zoom, 1, 1e-9);
    }
}

/// Whatever the focal point: no zoom brings the eye nearer to the body than half a radius, or than it was.
TEST(Camera, NoZoomLeadsIntoTheBody)
{
    for (double x = 0; x <= 5; x += 0.25)
        for (double y = -6; y <= 6; y += 0.25) {
            const double away = std::min(1.5, glm::length(eyeOf({x, y, 0}, 1)));
            for (double zoom = 1; zoom < 1e6; zoom *= 1.3)
                ASSERT_GE(glm::length(eyeOf({x, y, 0}, zoom)), away - 1e-9) << x << ", " << y << ", zoom " << zoom;
        }
}

/// The eye of a zoomed view does not jump while its focal point moves: into the sphere around the body, out of it, and
/// past it.
TEST(Camera, NoZoomedEyeJumpsWhereTheFocalPointMoves)
{
    constexpr double step = 1e-3, most = 0.1;  // Steep where the line of sight touches the sphere.
    for (const double zoom : {2.0, 8.0, 400.0})
        for (double at = -3; at <= 3; at += 0.3) {
            glm::dvec3 along = eyeOf({at, -4, 0}, zoom), across = eyeOf({-4, at, 0}, zoom);
            for (double moved = -4 + step; moved <= 4; moved += step) {
                const glm::dvec3 nextAlong = eyeOf({at, moved, 0}, zoom), nextAcross = eyeOf({moved, at, 0}, zoom);
                ASSERT_LT(glm::length(nextAlong - along), most) << at << ", " << moved << ", 0, zoom " << zoom;
                ASSERT_LT(glm::length(nextAcross - across), most) << moved << ", " << at << ", 0, zoom " << zoom;
                along = nextAlong;
                across = nextAcross;
            }
        }
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
    same.fov = zoomed.fovDeg;
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

/// What a page sends has to be a view that the server takes.
TEST(Camera, AStripLookedAtStraightOnIsZoomedNoNarrowerThanAViewMayBe)
{
    const Bounds strip{{0, 0, 0}, {100, 1, 0}};
    for (const double fovDeg : {1.0, 30.0})
        for (const auto& [width, height] : {std::pair(1000, 10), std::pair(10, 10), std::pair(10, 1000)}) {
            SceneDescription scene;
            scene.camera.fov = fovDeg;
            scene.camera.zoom = 1e6;
            scene.camera = straightAt(scene.camera, strip, width, height);
            EXPECT_NO_THROW(validate(scene)) << fovDeg << " degrees, " << width << "x" << height;
        }
}

}  // namespace
}  // namespace aeolic
