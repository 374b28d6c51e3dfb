#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "data/topology/surface_fans.h"

namespace aeolic {

/// The tangential part of a vector at each fan of a surface: angle in the fan, and length.
struct TangentField {
    std::vector<double> rad;     ///< [fans] as SurfaceFans::edgeRad counts.
    std::vector<double> length;  ///< [fans] 0: at rest; NaN: masked.
};

/// `vectors`: [points of the mesh] in the world's axes. Points in the same place take the first one's that is finite
/// among the fan's corners. Cost: O(triangles), parallel.
TangentField tangentField(const SurfaceMesh& mesh, const SurfaceFans& fans, const std::vector<glm::vec3>& vectors);

}  // namespace aeolic
