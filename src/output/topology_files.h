#pragma once

#include <string>

#include "aeolic/topology.h"

namespace aeolic {

/// "node", "focus", "centre", "saddle" or "multiple".
const char* nameOf(CriticalPointKind kind);

/// 1 where streamlines run into the point, -1 where they come out of it. A saddle, a centre and a point of a higher
/// kind have both: 0.
int attraction(const FlowPoint& point);

/// A topology as VTK XML polydata: a vertex for each critical point, and behind them a line for each separatrix. Arrays
/// of cells: `type` (0 node, 1 focus, 2 centre, 3 saddle, 4 of a higher kind, 5 line of separation, 6 line of
/// attachment), `attracts` (1, or -1 where it repels; 0 elsewhere), `index`, `strength`, `length`. Arrays of points:
/// `vectors`, and the scalar by its name.
std::string topologyVtp(const FlowTopology& topology);

/// A topology as comma-separated values with a heading. Critical points have a row each, in which the column `line` is
/// empty. The places of all lines follow, a row each, with the line's number from 0.
std::string topologyCsv(const FlowTopology& topology);

}  // namespace aeolic
