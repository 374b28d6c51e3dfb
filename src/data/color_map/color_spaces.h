#pragma once

#include "data/color_map/color_points.h"

namespace aeolic {

/// The colour at `t` (0 to 1) of the way between two sRGB colours, in `space`. It is rounded to 8 bits; what sRGB has
/// not is clamped. Sources: K. Moreland, Diverging Color Maps for Scientific Visualization (2009), for `diverging`;
/// CIE 15, D65, for `lab`.
Color between(const std::array<double, 3>& from, const std::array<double, 3>& to, double t, ColorSpace space);

}  // namespace aeolic
