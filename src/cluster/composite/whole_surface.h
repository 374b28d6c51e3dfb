#pragma once

#include <cstdint>
#include <vector>

#include "cluster/comm/communicator.h"
#include "data/mesh/surface_mesh.h"
#include "data/surface_range.h"
#include "data/vector_field.h"

/// What all ranks know together of a surface in pieces and of a field in bricks.
///
/// Triangles have numbers (SurfaceMesh::order). Several ranks may hold the triangle of a number, where triangles were
/// dealt to bricks. One rank may hold several of a number: the parts of a triangle that was cut.
namespace aeolic {

/// Triangles of all ranks' pieces, and where they come from.
struct GatheredTriangles {
    SurfaceMesh mesh;                   ///< In the order of their numbers.
    std::vector<std::int32_t> rank;     ///< [triangles] Whose piece has it.
    std::vector<std::uint32_t> ofRank;  ///< [triangles] Which of those that this rank gave.
};

/// Collective. These triangles of every rank's piece, on every rank: of a number those of the lowest rank that gives
/// any. Points that pieces share are in it as often as in the pieces. Cost: the triangles travel once, and a sort.
/// `triangles`: ascending.
GatheredTriangles gatherTriangles(Communicator& communicator, const SurfaceMesh& piece,
                                  const std::vector<std::uint32_t>& triangles);

/// Collective. All of a surface in pieces: gatherTriangles().
SurfaceMesh gatherSurface(Communicator& communicator, const SurfaceMesh& piece);

/// Collective. Which triangle of the whole surface, from 0, the triangle `which` of a rank's piece is. All ranks give
/// the same `rank`, and that one `which`. Cost: 8 bytes a triangle on their way.
std::uint64_t placeInWhole(Communicator& communicator, const SurfaceMesh& piece, int rank, std::uint32_t which);

/// vectorsAt() in the whole field, at points that are the same on all ranks. Collective where the field is in bricks,
/// else Local. Cost: of a field in bricks 32 bytes a point on their way.
std::vector<FieldVector> vectorsOfAll(Communicator& communicator, const GridField& field,
                                      const std::vector<glm::dvec3>& pointsWorld);

}  // namespace aeolic
