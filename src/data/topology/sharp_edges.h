#pragma once

#include "data/topology/surface_topology.h"

namespace aeolic {

/// Lays lines and points on sharp edges of the surface, where they lie within a triangle of one, and the flow beside it
/// runs to it from both sides, or, for lines of attachment, comes from it. Such an edge is the line. But a point of the
/// mesh on it has one vector, which cannot point to the edge from both sides; so the place where the flow turns round
/// is found a part of a triangle beside it. Cost: O(places).
void layOnSharpEdges(const FlowSurface& surface, SurfaceTopology& topology);

}  // namespace aeolic
