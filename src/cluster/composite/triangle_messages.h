#pragma once

#include <cstdint>
#include <vector>

#include "cluster/comm/communicator.h"
#include "data/surface_mesh.h"

namespace aeolic {

/// Calls visit(array) for everything that a mesh tells of each triangle beside its corners.
template <class Mesh, class Visit>
void forEachTriangleArray(Mesh& mesh, const Visit& visit)
{
    visit(mesh.order);
    visit(mesh.cellVectors);
    visit(mesh.cellScalars);
}

/// Part of a mesh as a message: these triangles, the points they use, and `points`, with all arrays. Empty where that
/// is nothing. It is: the triangles, then of the points positions, normals, vectors and scalars, then of the triangles
/// order, vectors and scalars; of each their number (64 bits; 0 where the mesh has no such array) and they.
Bytes triangleMessage(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& triangles,
                      std::vector<std::uint32_t> points);

/// Appends what a message holds to `mesh`, points counted on. Throws std::runtime_error naming the sender of a message
/// that is malformed, or has other arrays than those before.
void takeTriangles(const Message& message, SurfaceMesh& mesh);

}  // namespace aeolic
