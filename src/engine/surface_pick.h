#pragma once

#include <optional>

#include "aeolic/pick.h"
#include "data/scene.h"
#include "description/camera.h"

namespace aeolic {

/// What a picture of the scene shows at pixel (x, y); nothing where it shows the background. The scene is whole in this
/// process. Each triangle is met by the ray through the pixel's middle (Möller and Trumbore 1997), in doubles. Of faces
/// in the same place the one turned to the viewer counts, then the first. Cost: O(triangles), parallel; 1 M take some
/// milliseconds.
std::optional<PickedPlace> pickSurface(const Scene& scene, const Camera& camera, int x, int y);

}  // namespace aeolic
