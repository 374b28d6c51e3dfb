#pragma once

#include "data/streamlines/separation_lines.h"
#include "data/topology/surface_topology.h"
#include "render/overlay/surface_lines.h"

namespace aeolic {

/// A flow's topology as lines and marks, in the manner of oil-flow pictures. What the flow runs to (lines of
/// separation, points that attract) is red; what it comes from (lines of attachment, points that repel) is blue;
/// saddles are black crosses. Nodes are discs, foci rings with a dot, centres rings. The colours stay apart for the
/// colour-blind, and in gray print by their lightness.
std::vector<SurfaceLines::Style> topologyLines(const SurfaceTopology& topology, const SurfaceMesh& mesh);

/// Open lines of separation and attachment in the same colours, with heads that tell which way the flow along them
/// goes.
std::vector<SurfaceLines::Style> openLines(const StreamlineSurface& surface, const std::vector<SeparationLine>& lines);

/// The streamline through the place of a surface that is nearest to a point, with heads that tell which way it goes,
/// and the place itself. What comes to the place is thinner than what leaves it.
std::vector<SurfaceLines::Style> streamlineThrough(const StreamlineSurface& surface, const glm::dvec3& pointWorld);

}  // namespace aeolic
