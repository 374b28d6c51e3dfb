#include "engine/scene_view.h"

namespace aeolic {

CameraOptions sceneView(const CameraOptions& options, const Scene& scene, int width, int height)
{
    if (scene.isImage) return straightAt(options, scene.boundsWorld, width, height);
    return scene.planeNormal ? offEdge(options, *scene.planeNormal) : options;
}

}  // namespace aeolic
