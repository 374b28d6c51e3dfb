#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "aeolic/pick.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "description/camera.h"

namespace aeolic {

/// What a picture of the scene shows at pixel (x, y); nothing where it shows the background. The scene's surface is
/// whole in this process, or of it at least trianglesMet(); `lookUp`: its fields. Each triangle is met by the ray
/// through the pixel's middle (Möller and Trumbore 1997), in doubles. Of faces in the same place the one turned to the
/// viewer counts, then the first. Cost: O(triangles), parallel; 1 M take some milliseconds.
std::optional<PickedPlace> pickSurface(const Scene& scene, const Camera& camera, int x, int y,
                                       const FieldLookup& lookUp = vectorsAt);

/// The triangles of a piece of the surface that the picture may show at pixel (x, y): those that the ray meets first,
/// in the same place. Ascending. Cost: O(triangles), parallel.
std::vector<std::uint32_t> trianglesMet(const Scene& piece, const Camera& camera, int x, int y);

}  // namespace aeolic
