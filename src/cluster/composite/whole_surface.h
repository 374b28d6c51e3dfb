#pragma once

#include <cstdint>
#include <vector>

#include "cluster/comm/communicator.h"
#include "data/mesh/surface_mesh.h"
#include "data/surface_range.h"
#include "data/vector_field.h"

/// What all ranks know together of a surface in pieces and of a field in bricks.
namespace aeolic {

/// Collective. These triangles of every rank's piece, as one mesh that all ranks get: in the order of their numbers,
/// and each once, though several ranks may hold it. Points that pieces share are in it as often as in the pieces. Cost:
/// the triangles travel once, and a sort.
SurfaceMesh gatherTriangles(Communicator& communicator, const SurfaceMesh& piece,
                            const std::vector<std::uint32_t>& triangles);

/// Collective. All of a surface in pieces: gatherTriangles().
SurfaceMesh gatherSurface(Communicator& communicator, const SurfaceMesh& piece);

/// Collective. How many of the whole surface's triangles come before the number `order`, which is the same on all
/// ranks. Cost: 8 bytes a triangle on their way.
std::uint64_t trianglesBefore(Communicator& communicator, const SurfaceMesh& piece, std::uint64_t order);

/// vectorsAt() in the whole field, at points that are the same on all ranks. Collective where the field is in bricks,
/// else Local. Cost: of a field in bricks 32 bytes a point on their way.
std::vector<FieldVector> vectorsOfAll(Communicator& communicator, const GridField& field,
                                      const std::vector<glm::dvec3>& pointsWorld);

}  // namespace aeolic
