#pragma once

#include "data/color_map/color_points.h"

namespace aeolic {

/// A colour in the coordinates of some space.
using ColorTriple = std::array<double, 3>;

/// sRGB's transfer function and its inverse, of one channel.
double linearOfSrgb(double encoded);
double srgbOfLinear(double linear);

ColorTriple times(const double (&m)[3][3], const ColorTriple& v);

/// The colour at `t` (0 to 1) of the way between two sRGB colours, in `space`. It is rounded to 8 bits; what sRGB has
/// not is clamped. Sources: K. Moreland, Diverging Color Maps for Scientific Visualization (2009), for `diverging`;
/// CIE 15, D65, for `lab`.
Color between(const ColorTriple& from, const ColorTriple& to, double t, ColorSpace space);

}  // namespace aeolic
