#pragma once

#include <glm/glm.hpp>

#include "data/scene.h"
#include "data/topology/surface_place.h"

namespace aeolic {

/// Which of several surfaces a triangle of `mesh` is of; null where there is only one.
const SceneSurface* surfaceOf(const Scene& scene, const SurfaceMesh& mesh, std::uint32_t triangle);

/// What a scene is coloured by at a place of `mesh`, which is the scene's surface or a finer one of the same points;
/// NaN where there is none. `position`, in world coordinates, and `vector` are those of the place.
double scalarAt(const Scene& scene, const SurfaceMesh& mesh, const SurfacePlace& place, const glm::dvec3& position,
                const glm::dvec3& vector);

/// The vector that the scene has at a place of its surface, in world axes; NaN where there is none.
glm::dvec3 vectorAt(const Scene& scene, const SurfacePlace& place, const glm::dvec3& position);

}  // namespace aeolic
