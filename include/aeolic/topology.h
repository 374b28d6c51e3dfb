#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// A place on a surface, with what the surface has there.
struct SurfaceValues {
    Vec3 position{0, 0, 0};  ///< World units.
    Vec3 vector{0, 0, 0};    ///< As the data have it, not only its part along the surface.
    double scalar = 0;       ///< What the surface is coloured by; NaN where there is none.
};

/// What the flow along a surface does around a point where it vanishes. `multiple`: a point of a higher kind.
enum class CriticalPointKind { node, focus, centre, saddle, multiple };

struct FlowPoint {
    SurfaceValues at;
    CriticalPointKind kind = CriticalPointKind::node;
    bool attracts = false;  ///< A node or focus that streamlines run into; else they come out of it.
    int index = 1;          ///< Turns of the flow around it: 1 for a node, focus or centre, -1 for a saddle.
    double strength = 0;    ///< Of the flow's derivative: the root of its determinant, 1 / time for velocities.
};

/// A line of separation or of attachment: one that begins at a saddle and parts regions of the flow, or an open one,
/// which streamlines gather at.
struct FlowLine {
    std::optional<std::size_t> saddle;  ///< Which of FlowTopology::points; nothing: it is an open line.
    std::optional<std::size_t> end;     ///< The point it ends at; nothing where it leaves the surface or closes.
    bool separates = true;              ///< It runs downstream, a line of separation; else upstream, one of attachment.
    double length = 0;                  ///< World units.
    double strength = 0;                ///< That of its saddle. Of an open line: by which power of e streamlines lie
                                        ///< closer on it than on average.
    std::vector<SurfaceValues> places;  ///< From the saddle on; of an open line downstream.
};

/// The skeleton of the flow along a surface (docs/topology.md).
struct FlowTopology {
    std::vector<FlowPoint> points;
    std::vector<FlowLine> lines;
    std::string scalar;  ///< The array's name; empty where there is none.
};

}  // namespace aeolic
