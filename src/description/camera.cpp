#include "description/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "aeolic/error.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

constexpr double kMargin = 1.04;              // Times the size of a fitted surface: it keeps a little room.
constexpr double kNearOverFar = 1.0 / 16384;  // The nearest depth a view from inside a surface can show.
// In radii of the fitted sphere:
constexpr double kNearestZoom = 1.5;  // A zoom's eye comes no nearer to the centre (web/view/zoom.js knows it, too).
constexpr double kBesideZoom = 2;     // A way this far beside the centre is not kept from leading past it (as above).
constexpr double kFarBody = 2;        // From so far away the focal point says nothing about the depth of the body.
constexpr double kLeastBodyDepth = 1.0 / 64;  // Steps that an eye within the surface sees have some length.

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

// From the focal point to the eye of a view given by angles.
glm::dvec3 outwardOf(const CameraOptions& options)
{
    const double az = radians(options.azimuth), el = radians(options.elevation);
    return {std::sin(az) * std::cos(el), -std::cos(az) * std::cos(el), std::sin(el)};
}

// A vector not parallel to `forward`, for views that do not say where up is.
glm::dvec3 defaultUp(const glm::dvec3& forward)
{
    return std::abs(forward.z) < 0.999 * glm::length(forward) ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
}

struct DepthRange {
    double near, far;
};

// The depths that a surface can have in the picture: those of its bounding sphere and of its box, with a little room
// for rounding. A narrow view sees nothing that is near beside it.
DepthRange depthsOf(const SurfaceReach& surface, const glm::dvec3& center, const Camera& camera)
{
    const auto depthOf = [&](const glm::dvec3& p) { return glm::dot(p - camera.positionWorld, camera.forward); };
    const double room = 1e-3 * surface.radius;
    DepthRange depths{depthOf(center) - surface.radius, depthOf(center) + surface.radius};
    if (!surface.boundsWorld.empty()) {
        const Bounds& box = surface.boundsWorld;
        const double middle = depthOf(box.center()), half = 0.5 * glm::dot(box.hi - box.lo, glm::abs(camera.forward));
        depths = {std::max(depths.near, middle - half), std::min(depths.far, middle + half)};
    }
    const double halfX = 0.5 * camera.width / camera.focalPx, halfY = 0.5 * camera.height / camera.focalPx;
    const double outside = glm::length(center - camera.positionWorld) - surface.radius - room;
    const double seen = std::max(outside, 0.0) / std::sqrt(1 + halfX * halfX + halfY * halfY);
    const double far = std::max(depths.far, 0.0) + room;
    return {std::max(depths.near - room, seen < far ? seen : 0.0), far};
}

// How far from the focal point, towards the eye, a zoom leaves the sphere that it stays outside of. 0 where that way
// does not meet the sphere: no zoom leads into the body then. Between a way that touches it and one well past it the
// distance shrinks to 0 little by little, so that the eye does not jump while a view turns or moves.
double nearestZoomDistance(const glm::dvec3& focalFromCenter, const glm::dvec3& outward, double radius)
{
    const double nearest = kNearestZoom * radius, beside = kBesideZoom * radius;
    const double along = glm::dot(focalFromCenter, outward), aside = glm::length(focalFromCenter - along * outward);
    const double farEnd = aside < nearest ? std::sqrt(nearest * nearest - aside * aside) - along
                                          : -along * std::max(0.0, (beside - aside) / (beside - nearest));
    return std::max(0.0, farEnd);
}

// The depth that the body counts as seen at. From afar that of its centre, wherever on the line of sight the focal
// point is; the nearer the eye, the less does the centre say, and the more does the focal point count. Continuous, so
// nothing jumps while a camera moves.
double bodyDepthOf(const Camera& camera, const glm::dvec3& center, double radius, bool looksAtCenter)
{
    const double least = kLeastBodyDepth * radius;
    if (looksAtCenter) return std::max(camera.focalDistance, least);
    const glm::dvec3 toCenter = center - camera.positionWorld;
    const double depth = glm::dot(toCenter, camera.forward);
    const double slack = std::clamp(kFarBody * radius - glm::length(toCenter), 0.0, radius);
    return std::max(std::clamp(camera.focalDistance, depth - slack, depth + slack), least);
}

/// Nobody chose where to look from.
bool isDefaultView(const CameraOptions& options)
{
    const CameraOptions usual;
    return !options.position && !options.focal && !options.up && options.azimuth == usual.azimuth &&
           options.elevation == usual.elevation && options.roll == usual.roll;
}

}  // namespace

Camera makeCamera(const CameraOptions& options, const Bounds& boundsWorld, double radius, int width, int height,
                  const SurfaceReach& now)
{
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.fovDeg = options.fov;
    const double tanHalf = std::tan(radians(options.fov) / 2);

    const glm::dvec3 center = boundsWorld.empty() ? glm::dvec3(0) : boundsWorld.center();
    const double safeRadius = radius > 0 ? radius : 1.0;
    const glm::dvec3 focal = options.focal ? vectorOf(*options.focal) : center;
    glm::dvec3 upHint;
    if (options.position) {
        camera.positionWorld = vectorOf(*options.position);
        camera.forward = focal - camera.positionWorld;
        upHint = options.up ? vectorOf(*options.up) : defaultUp(camera.forward);
    } else {
        // The narrower side of the image decides how far away the whole sphere is in view.
        const double tanFit = tanHalf * std::min(1.0, double(width) / height);
        const double whole = kMargin * safeRadius / std::sin(std::atan(tanFit));
        const glm::dvec3 outward = outwardOf(options);
        // A zoom comes closer until it would come near the body, then it narrows the field of view instead. The scale
        // at the focal point is proportional to it either way.
        const double asked = whole / options.zoom;
        const double nearest = std::min(whole, nearestZoomDistance(focal - center, outward, safeRadius));
        const double distance = std::max(asked, nearest);
        if (asked < nearest) camera.fovDeg = degrees(2 * std::atan(tanHalf * asked / nearest));
        camera.positionWorld = focal + distance * outward;
        camera.forward = -outward;
        const double az = radians(options.azimuth), el = radians(options.elevation);
        // Differentiating by the elevation keeps "up" continuous over the poles.
        upHint = options.up ? vectorOf(*options.up)
                            : glm::dvec3(-std::sin(az) * std::sin(el), std::cos(az) * std::sin(el), std::cos(el));
    }
    camera.focalPx = 0.5 * height / std::tan(radians(camera.fovDeg) / 2);
    camera.focalDistance = options.position ? glm::length(camera.forward) : glm::length(focal - camera.positionWorld);
    if (!(camera.focalDistance > 0) || !std::isfinite(camera.focalDistance))
        throw InputError("--camera", "position and focal point coincide", "two different points");
    camera.forward = glm::normalize(camera.forward);
    camera.right = glm::cross(camera.forward, upHint);
    if (!(glm::length(camera.right) > 1e-9 * glm::length(upHint)))
        throw InputError("--camera", "up is zero or parallel to the view", "a direction across it");
    camera.right = glm::normalize(camera.right);
    camera.up = glm::cross(camera.right, camera.forward);
    if (options.roll != 0 && !options.position) {
        const double roll = radians(options.roll);
        const glm::dvec3 right = camera.right, up = camera.up;
        camera.right = std::cos(roll) * right + std::sin(roll) * up;
        camera.up = std::cos(roll) * up - std::sin(roll) * right;
    }

    camera.bodyDepth = bodyDepthOf(camera, center, safeRadius, !options.focal);

    const SurfaceReach fitted{boundsWorld, safeRadius};
    const DepthRange depths = depthsOf(now.boundsWorld.empty() ? fitted : now, center, camera);
    camera.farDepth = depths.far;
    camera.nearDepth = std::max(depths.near, kNearOverFar * camera.farDepth);
    return camera;
}

double orbitDegOf(const SceneDescription& scene)
{
    const bool isMoving = scene.time.range || scene.lic.flow == FlowMotion::loop;
    return scene.output.orbit.value_or(isMoving ? 0.0 : 360.0);
}

CameraOptions offEdge(const CameraOptions& options, const glm::dvec3& planeNormal)
{
    constexpr double leastDeg = 15;  // Between plane and view: a square is a quarter as high as wide then.
    const double part = glm::dot(planeNormal, outwardOf(options));
    if (!isDefaultView(options) || std::abs(part) >= std::sin(radians(leastDeg))) return options;
    const glm::dvec3 from = part < 0 ? -planeNormal : planeNormal;  // From the side that the default view is on.
    CameraOptions straight = options;
    straight.azimuth = degrees(std::atan2(from.x, -from.y));
    straight.elevation = degrees(std::asin(std::clamp(from.z, -1.0, 1.0)));
    return straight;
}

CameraOptions straightAt(const CameraOptions& options, const Bounds& planeWorld, int width, int height)
{
    if (!isDefaultView(options) || planeWorld.empty()) return options;
    const glm::dvec3 size = planeWorld.hi - planeWorld.lo, center = planeWorld.center();
    const int flat = size.z == 0 ? 2 : size.y == 0 ? 1 : 0;
    const double across = flat == 0 ? size.y : size.x, high = flat == 2 ? size.y : size.z;
    const double shown = std::max(high, across * height / width) / options.zoom;
    const double asked = shown / 2 / std::tan(radians(options.fov) / 2);
    const double nearest = std::min(asked * options.zoom, kNearestZoom * glm::length(size) / 2);
    const double distance = std::max(asked, nearest);
    glm::dvec3 eye = center;
    eye[flat] += flat == 1 ? -distance : distance;
    CameraOptions straight = options;
    if (asked < nearest) straight.fov = degrees(2 * std::atan(shown / 2 / nearest));
    straight.position = Vec3{eye.x, eye.y, eye.z};
    straight.focal = Vec3{center.x, center.y, center.z};
    straight.up = flat == 2 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    return straight;
}

CameraOptions orbited(const CameraOptions& options, double degrees, const Bounds& boundsWorld)
{
    CameraOptions turned = options;
    if (degrees == 0) return turned;
    if (!options.position) {
        turned.azimuth += degrees;
        return turned;
    }
    const glm::dvec3 focal = options.focal         ? vectorOf(*options.focal)
                             : boundsWorld.empty() ? glm::dvec3(0)
                                                   : boundsWorld.center();
    const glm::dvec3 from = vectorOf(*options.position) - focal,
                     up = options.up ? vectorOf(*options.up) : defaultUp(-from);
    if (!(glm::length(up) > 0)) return turned;  // makeCamera() reports the fault.
    const glm::dvec3 axis = glm::normalize(up);
    const double angle = radians(degrees);
    // Rodrigues' formula.
    const glm::dvec3 p = focal + from * std::cos(angle) + glm::cross(axis, from) * std::sin(angle) +
                         axis * (glm::dot(axis, from) * (1 - std::cos(angle)));
    turned.position = Vec3{p.x, p.y, p.z};
    return turned;
}

}  // namespace aeolic
