#include "engine/flow_values.h"

#include <limits>

#include "engine/place_values.h"

namespace aeolic {

SurfaceValues FlowValues::at(const SurfacePlace& place) const
{
    const glm::dvec3 position = positionWorld(flow_.mesh, place);
    const auto& corners = flow_.mesh.triangles[place.triangle];
    glm::dvec3 vector(0);
    for (int i = 0; i < 3; ++i) vector += place.weight[i] * glm::dvec3(flow_.vectors[corners[std::size_t(i)]]);
    return {{position.x, position.y, position.z}, {vector.x, vector.y, vector.z}, scalarOf(place, position, vector)};
}

double FlowValues::scalarOf(const SurfacePlace& place, const glm::dvec3& position, const glm::dvec3& vector) const
{
    const SceneSurface* const surface = surfaceOf(scene_, flow_.mesh, place.triangle);
    if (surface && surface->colors != 0) return std::numeric_limits<double>::quiet_NaN();  // Of another array.
    return scalarAt(scene_, flow_.mesh, place, position, vector);
}

}  // namespace aeolic
