#pragma once

#include <vector>

#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// Several meshes as one, about `originWorld`. SurfaceMesh::surfaceOf tells where a point comes from; null stands for a
/// surface that is left out. Vectors and scalars are on the points: those of a mesh that has them on its triangles
/// become those of the triangles' corners, which then share no points. Where only some meshes have vectors, those of
/// the others are zero; missing scalars are NaN. At most 256 meshes. Cost: one pass over each.
SurfaceMesh joinMeshes(const std::vector<const SurfaceMesh*>& meshes, const glm::dvec3& originWorld);

}  // namespace aeolic
