#pragma once

#include <cstdint>
#include <vector>

#include "cluster/comm/communicator.h"
#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// Calls visit(array) for every array that has a value for each triangle, beside the corners.
template <class Mesh, class Visit>
void forEachTriangleArray(Mesh& mesh, const Visit& visit)
{
    visit(mesh.order);
    visit(mesh.cellVectors);
    visit(mesh.cellScalars);
}

/// Part of a mesh as a message: these triangles, the points they use, and `points`, with all arrays. Empty where that
/// is nothing. A message is: the triangles; then positions, normals, vectors and scalars of the points; then order,
/// vectors and scalars of the triangles. Each begins with its number of values (64 bits; 0: the mesh has no such
/// array).
Bytes triangleMessage(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& triangles,
                      const std::vector<std::uint32_t>& points);

/// Appends what a message holds to `mesh`, its points numbered after those there. Throws std::runtime_error naming the
/// sender of a message that is malformed, or has other arrays than those before.
void takeTriangles(const Message& message, SurfaceMesh& mesh);

}  // namespace aeolic
