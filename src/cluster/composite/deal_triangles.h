#pragma once

#include "cluster/comm/communicator.h"
#include "data/surface_mesh.h"
#include "data/vector_field.h"

namespace aeolic {

/// Collective. Of a surface that the ranks hold in pieces, in a field that they hold in bricks: gives every rank the
/// triangles that reach into its own cells, or within a cell of them; beyond the field, the nearest cells. So whoever
/// owns the cell that a visible pixel is in holds the pixel's triangle, and each triangle is held by somebody. One that
/// reaches into several bricks is held by several ranks, with the same numbers in `order`.
///
/// `piece`: positions about the same origin everywhere, finished, numbered; `field`: this rank's brick. Points that no
/// triangle uses stay where they are, so that minima and maxima over all ranks' points are still the surface's. Every
/// array comes along. Cost: the piece travels once; log(ranks) a triangle, and ranks for one that leaves its brick.
///
/// `dealtBy`: `piece` was dealt by the bricks of this field, of which no samples are looked at; null: by none, every
/// triangle is one rank's.
SurfaceMesh dealToBricks(Communicator& communicator, SurfaceMesh piece, const GridField& field,
                         const GridField* dealtBy = nullptr);

}  // namespace aeolic
