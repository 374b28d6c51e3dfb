#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/mesh/mesh_edges.h"
#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// [points] the first of those in the same place, which may be the point itself. Cost: a sort.
std::vector<std::uint32_t> firstsOfPlaces(const std::vector<glm::vec3>& positions);

/// The mesh's triangles, with one index for points in the same place. Cost: that of firstsOfPlaces().
std::vector<Triangle> joinedTriangles(const SurfaceMesh& mesh);

}  // namespace aeolic
