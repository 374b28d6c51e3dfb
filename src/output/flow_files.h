#pragma once

#include <string>

#include "aeolic/streamlines.h"
#include "aeolic/topology.h"

/// What the flow on a surface has, as VTK XML polydata and as comma-separated values with a heading. Arrays of points
/// are `vectors`, and the scalar by its name, where it has one.
namespace aeolic {

/// "node", "focus", "centre", "saddle" or "multiple".
const char* nameOf(CriticalPointKind kind);

/// 1 where streamlines run into the point, -1 where they come out of it. A saddle, a centre and a point of a higher
/// kind have both: 0.
int attraction(const FlowPoint& point);

/// A vertex for each critical point, and behind them a line for each separatrix. Arrays of cells: `type` (0 node,
/// 1 focus, 2 centre, 3 saddle, 4 of a higher kind, 5 line of separation, 6 line of attachment), `attracts` (1, or -1
/// where it repels; 0 elsewhere), `index`, `strength`, `length`.
std::string topologyVtp(const FlowTopology& topology);

/// Critical points have a row each, in which the column `line` is empty. The places of all lines follow, a row each,
/// with the line's number from 0.
std::string topologyCsv(const FlowTopology& topology);

/// A line for each streamline. Arrays of cells: `closed` (1, or 0) and `length`.
std::string streamlinesVtp(const EvenSurfaceLines& lines);

/// A row for each place, with the line's number from 0.
std::string streamlinesCsv(const EvenSurfaceLines& lines);

}  // namespace aeolic
