#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "aeolic/topology.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "data/topology/point_flow.h"
#include "data/topology/surface_place.h"

namespace aeolic {

/// Which of several surfaces a triangle of `mesh` is of; null where there is only one.
const SceneSurface* surfaceOf(const Scene& scene, const SurfaceMesh& mesh, std::uint32_t triangle);

/// What a scene is coloured by at a place of `mesh`, which is the scene's surface or a finer one of the same points;
/// NaN where there is none. `vector`: that of the place; `ofField`: what Scene::scalarField has there.
double scalarAt(const Scene& scene, const SurfaceMesh& mesh, const SurfacePlace& place, const glm::dvec3& vector,
                const FieldVector& ofField);

/// The vector that the scene has at a place of its surface, in world axes; NaN where there is none. `ofField`: what
/// Scene::field has there.
glm::dvec3 vectorAt(const Scene& scene, const SurfacePlace& place, const FieldVector& ofField);

/// [places] What a scene has at places of the flow's mesh, by the flow at points. The scene's surface is whole in this
/// process; `lookUp`: its fields.
std::vector<SurfaceValues> valuesAt(const Scene& scene, const PointFlow& flow, const std::vector<SurfacePlace>& places,
                                    const FieldLookup& lookUp);

}  // namespace aeolic
