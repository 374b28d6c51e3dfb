#pragma once

#include <algorithm>
#include <cmath>

namespace aeolic {

inline constexpr double kMostFrontBias = 1.0 / 1024, kFrontRounding = 1.0 / (1 << 20);  ///< Of 1/depth.

/// By how much a face that is turned to the viewer counts as nearer, in 1/depth: so much that it shows before another
/// face in the same place, whichever way either is cut into triangles. Corners lie on whole sub-pixels of the image, so
/// each plane is off by up to half a sub-pixel in x and y. `depthX`, `depthY`: change per sub-pixel; `lowest` and
/// `highest` corner. On planes that are seen nearly from the edge that is a lot, so it is never more than a 1024th.
inline double frontBias(double depthX, double depthY, double lowest, double highest)
{
    const double snapped = std::min(std::abs(depthX) + std::abs(depthY), highest - lowest);
    return std::min(snapped, kMostFrontBias * highest) + kFrontRounding * highest;
}

}  // namespace aeolic
