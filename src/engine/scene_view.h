#pragma once

#include "data/scene.h"

namespace aeolic {

/// The view of a scene that `options` ask for, in a picture of this shape. Where they are the default view, a plane is
/// looked at so that it is seen: an image straight on, and a slice too, unless the default view shows it.
CameraOptions sceneView(const CameraOptions& options, const Scene& scene, int width, int height);

}  // namespace aeolic
