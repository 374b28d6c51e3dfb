#pragma once

#include <vector>

#include "data/topology/critical_points.h"
#include "data/topology/surface_tracer.h"

namespace aeolic {

/// A streamline that begins or ends at a saddle, and parts what flows to one side from what flows to the other.
struct Separatrix {
    std::size_t saddle = 0;  ///< Which of the critical points.
    int direction = 1;       ///< 1: it leaves the saddle, -1: it runs into it.
    SurfaceLine line;        ///< From the saddle on.
};

/// The separatrices that leave each saddle and those that run into it, in the order of the points: two and two, unless
/// the saddle is a point of the mesh, around which the flow is linear in each triangle by itself. They end where
/// SurfaceTracer's lines end, and after `longestWorld`. Cost: that of the lines, parallel.
std::vector<Separatrix> separatrices(const FlowSurface& surface, const std::vector<CriticalPoint>& points,
                                     double longestWorld);

}  // namespace aeolic
