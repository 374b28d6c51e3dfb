#pragma once

/// The control points of the teapot: Martin Newell, "The Utilization of Procedure Models in Digital Image Synthesis",
/// PhD thesis, University of Utah, 1975, in the proportions Jim Blinn gave it (z divided by 1.3) and with Frank Crow's
/// bottom ("The Origins of the Teapot", IEEE CG&A 7(1), 1987). These are the published numbers, in the public domain.
/// The 32 patches repeat themselves: parts of revolution are one quarter turned four times, handle and spout are one
/// half and its mirror image. Only the quarter and the half are written down; turning and mirroring are exact.

#include <array>

namespace aeolic {

/// Four control points of a quarter circle, clockwise seen from above:
/// (radius, 0, z), (radius, -tangent, z), (tangent, -radius, z), (0, -radius, z).
struct TeapotRing {
    double radius, tangent, z;
};
using TeapotQuarter = std::array<TeapotRing, 4>;

/// Four control points of a half ring of handle or spout:
/// (x0, 0, z0), (x0, -halfWidth, z0), (x1, -halfWidth, z1), (x1, 0, z1).
struct TeapotHalfRing {
    double x0, z0, x1, z1, halfWidth;
};
using TeapotHalf = std::array<TeapotHalfRing, 4>;

/// Rim, upper body, lower body, bottom, then the lid's knob and the lid; rings in the order of a profile drawn from the
/// top to the bottom's centre. Where the knob begins and the bottom ends, the ring is a single point.
inline constexpr std::array<TeapotQuarter, 6> teapotQuarters{{
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2, 1.12, 1.35}, {2, 1.12, 0.9}}},
    {{{2, 1.12, 0.9}, {2, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},
    {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0}, {0, 0, 0}}},
    {{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}},
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},
}};

/// Handle from the rim to its bend, handle from there to the body; spout from the body upwards, spout's lip.
inline constexpr std::array<TeapotHalf, 4> teapotHalves{{
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3, 1.8, 0.3},
      {-2.7, 1.575, -3, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

}  // namespace aeolic
