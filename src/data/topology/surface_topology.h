#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "data/topology/critical_points.h"

namespace aeolic {

/// A line that parts regions of the flow. From a saddle downstream the streamlines beside it come closer: a line of
/// separation. Upstream they come closer when they are followed backwards: a line of attachment (Tobak and Peake,
/// "Topology of three-dimensional separated flows", Annual Review of Fluid Mechanics 14, 1982).
struct TopologyLine {
    std::size_t saddle = 0;  ///< Which of SurfaceTopology::points it begins at.
    std::optional<std::size_t>
        other;          ///< The point that it ends at; nothing where it leaves the surface, or is closed.
    int direction = 1;  ///< 1: downstream, -1: upstream.
    double lengthWorld = 0;
    std::vector<SurfacePlace> places;  ///< From the saddle on.
};

/// The skeleton of a surface's flow: its critical points, and the separatrices between them.
struct SurfaceTopology {
    std::vector<CriticalPoint> points;
    std::vector<TopologyLine> lines;
};

/// The topology of the flow on a surface. `vectors`: [points of the mesh], in the world's axes. Only what lies in the
/// surface counts. Cost: O(triangles), and that of the lines; parallel. The same from any number of threads.
///
/// Pairs cancel in the order of their distance, the least first (in the manner of Morse complexes: Edelsbrunner, Harer
/// and Zomorodian, "Hierarchical Morse-Smale complexes", DCG 30, 2003). A line that came to one of a pair goes on
/// along the line between them and along the saddle's other line.
///
/// `persistence`: a saddle and a point that it is joined with cancel each other where they are no farther apart along
/// the line than this, as a part of the surface's size (the diagonal of the box of the points that have flow): so noise
/// of the data goes. 0: all stay.
SurfaceTopology surfaceTopology(const SurfaceMesh& mesh, const std::vector<glm::vec3>& vectors,
                                double persistence = 0.01);

}  // namespace aeolic
