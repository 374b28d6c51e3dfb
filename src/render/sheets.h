#pragma once

/// Constants of the sheet test, shared by every backend and the reference (see cpu/links.h for the rule).
namespace aeolic::sheets {

/// A prediction holds if it is off by no more than this many pixel footprints in depth …
inline constexpr float kSlackFootprints = 1.5f;
/// … plus this share of the steeper facet's change per pixel: curvature within a pixel.
inline constexpr float kSlackSlope = 0.1f;

}  // namespace aeolic::sheets
