#pragma once

#include <cstdint>

/// Anti-aliasing (docs/decisions/0021-antialiasing.md): where silhouettes and creases run, the surface is looked up at
/// several places of a pixel, and the pixel is the mean of what they show. All other pixels stay what they are.
namespace aeolic::antialias {

/// Places looked at in each pixel of an edge.
inline constexpr int kSamples = 8;
/// Where they are, from the pixel's centre, in 16ths of a pixel to the right and downwards: no two in one column or
/// row, and as far from each other as that allows.
inline constexpr int kParts = 16;
inline constexpr std::int32_t kRight[kSamples] = {1, -1, 5, -3, -5, -7, 3, 7};
inline constexpr std::int32_t kDown[kSamples] = {-3, 3, 1, -5, 5, -1, 7, -7};
/// The farthest from the centre, in either direction.
inline constexpr int kReach = 7;

/// Where the light of a pixel and its neighbours falls into a dark and a bright part that are farther apart than this,
/// there is an edge, even on one sheet: a crease.
inline constexpr float kLightStep = 1.0f / 24;
/// The light of either part may differ by this share of the whole step. On a rough surface it differs by more, and all
/// pixels would be edges.
inline constexpr float kUneven = 1.0f / 8;
/// What the square of a pixel's distance adds to how badly it fits a sample, in shares of the slack of limits.h. So the
/// nearer pixel's sheet counts where several fit equally well.
inline constexpr float kDistanceShare = 1.0f / 16;
/// A pixel that fits no worse is taken before those farther away are looked at, in shares of the slack.
inline constexpr float kFits = 1.0f / 8;

}  // namespace aeolic::antialias
