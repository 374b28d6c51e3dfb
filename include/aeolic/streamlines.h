#pragma once

#include <string>
#include <vector>

#include "aeolic/topology.h"

namespace aeolic {

/// A streamline on a surface.
struct SurfaceStreamline {
    double length = 0;                  ///< World units.
    bool closed = false;                ///< It comes back to its beginning: the first place and the last are the same.
    std::vector<SurfaceValues> places;  ///< Downstream.
};

/// Streamlines that keep about the same distance from each other (docs/overlays.md).
struct EvenSurfaceLines {
    double spacing = 0;  ///< World units; lines come no nearer to each other than about half of it.
    std::vector<SurfaceStreamline> lines;
    std::string scalar;  ///< The name of what the surface is coloured by; empty where there is none.
};

}  // namespace aeolic
