#pragma once

#include <vector>

#include "data/streamlines/streamline_surface.h"

namespace aeolic {

/// A streamline that others gather at, from both sides: of separation where they do so downstream, of attachment where
/// they do so upstream. It needs no critical point to begin or to end at.
struct SeparationLine {
    bool separates = true;  ///< Else it is a line of attachment.
    double lengthWorld = 0;
    /// By which power of e streamlines lie closer on it than on average, those that begin within 0.4 of the surface's
    /// size of there.
    double strength = 0;
    std::vector<SurfacePlace> places;  ///< Downstream.
};

/// The lines of separation and attachment on a surface, the strongest first, those of separation before the others.
/// `persistence`: lines closer together than this part of the surface's size are one, and none is shorter than six
/// times that; within [0.005, 0.1].
///
/// Streamlines that begin all over the surface are followed for a while. Where they come to lie much closer than
/// elsewhere, and closer than on either side, they have met such a line (in the manner of Tricoche, Garth and
/// Scheuermann, "Fast and robust extraction of separation line features", in: Scientific Visualization: The Visual
/// Extraction of Knowledge from Data, 2006). No derivatives are taken, so noise does little. Cost: that of some 4,000
/// streamlines, parallel. The same from any number of threads.
std::vector<SeparationLine> separationLines(const StreamlineSurface& surface, double persistence);

}  // namespace aeolic
