#include "engine/scene_view.h"

#include <algorithm>

namespace aeolic {
namespace {

Vec3 numbers(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

/// The view that fits the surfaces that are shown, where some are hidden. It is absolute, so that all else goes by the
/// whole scene: the same view has the same streaks, whatever is hidden.
CameraOptions fittedToShown(const CameraOptions& options, const Scene& scene, int width, int height)
{
    const SurfaceReach fit = scene.fit();
    const Camera camera = makeCamera(options, fit.boundsWorld, fit.radius, width, height);
    CameraOptions fitted;
    fitted.position = numbers(camera.positionWorld);
    fitted.focal = numbers(camera.positionWorld + camera.focalDistance * camera.forward);
    fitted.up = numbers(camera.up);
    fitted.fov = camera.fovDeg;
    return fitted;
}

}  // namespace

CameraOptions sceneView(const CameraOptions& options, const Scene& scene, int width, int height)
{
    if (scene.isImage) return straightAt(options, scene.boundsWorld, width, height);
    if (scene.planeNormal) return offEdge(options, *scene.planeNormal);
    const auto isShown = [](const SceneSurface& surface) { return surface.shown; };
    const bool isWhole = std::all_of(scene.surfaces.begin(), scene.surfaces.end(), isShown);
    return options.position || isWhole ? options : fittedToShown(options, scene, width, height);
}

}  // namespace aeolic
