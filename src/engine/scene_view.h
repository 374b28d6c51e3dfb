#pragma once

#include "data/scene.h"

namespace aeolic {

/// The view of a scene that `options` ask for, in a picture of this shape. Where they are the default view, a plane is
/// looked at so that it is seen: an image straight on, and a slice too, unless the default view shows it. Where some
/// of several surfaces are hidden, the view fits those that are shown.
CameraOptions sceneView(const CameraOptions& options, const Scene& scene, int width, int height);

}  // namespace aeolic
