#pragma once

#include "cluster/comm/communicator.h"
#include "data/mesh/surface_mesh.h"
#include "data/vector_field.h"

namespace aeolic {

/// Collective. The ranks hold a surface in pieces and a field in bricks. Gives every rank the triangles that reach into
/// its own cells, or within a cell of them; beyond the field the nearest cells count. So the rank that owns the cell of
/// a visible pixel holds the pixel's triangle, and each triangle is held by somebody. One that reaches into several
/// bricks is held by several ranks, with the same numbers in `order`.
///
/// `piece`: positions about the same origin everywhere, finished, numbered; `field`: this rank's brick. Points that no
/// triangle uses stay where they are, so that minima and maxima over all ranks' points are still the surface's. Every
/// array comes along. Cost: the piece travels once; log(ranks) a triangle, and ranks for one that leaves its brick.
///
/// `dealtBy`: the field by whose bricks `piece` was dealt before; its samples are not looked at. Null: it was not
/// dealt, and every triangle is one rank's.
SurfaceMesh dealToBricks(Communicator& communicator, SurfaceMesh piece, const GridField& field,
                         const GridField* dealtBy = nullptr);

}  // namespace aeolic
