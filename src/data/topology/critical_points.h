#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "aeolic/topology.h"
#include "data/topology/surface_place.h"
#include "data/topology/tangent_field.h"

namespace aeolic {

using CriticalKind = CriticalPointKind;

/// A point of a surface where the flow along it vanishes.
struct CriticalPoint {
    SurfacePlace place;
    int index = 0;  ///< Turns of the flow around it: 1 for a node, a focus, a centre, -1 for a saddle. Not 0.
    CriticalKind kind = CriticalKind::multiple;
    bool attracts = false;  ///< A node or focus that streamlines run into; else they come out of it.
    double strength = 0;    ///< The root of the determinant of the flow's derivative, as a length: 1 / time.
};

/// The critical points of the flow, in the order of triangles. A triangle has one where the flow turns around it: the
/// rotation along its sides, by discrete transport between the points, and what transport itself turns. So on a closed
/// surface without points at rest the indices sum up to the Euler characteristic. Triangles with a masked corner, or
/// with more than one at rest, have none. Cost: O(triangles), parallel.
std::vector<CriticalPoint> criticalPoints(const FlowSurface& surface);

}  // namespace aeolic
