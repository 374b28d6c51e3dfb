#pragma once

#include <cstdint>
#include <limits>

#include "render/lic/noise.h"

namespace aeolic {

/// Grains of oriented streaks in a plane: a cut through their pyramid, where a texel is two pixels wide.
struct PlaneGrains {
    explicit PlaneGrains(std::uint32_t seed)
        : pyramid(seed, Style::oriented), lookup(makeNoiseLookup(1024, 1, Style::oriented))
    {
    }

    NoisePyramid pyramid;
    NoiseLookup lookup;
};

/// Numbers of a row of a plane, and how they become what the LIC stage reads.
struct PlanePixels {
    const float *u, *v;
    const float* texture;       ///< Null: grains, or white noise where there are none of those, either.
    const PlaneGrains* grains;  ///< Of oriented streaks.
    int y;                      ///< The row,
    std::uint32_t first;        ///< its first pixel's number in the plane, and
    std::uint32_t seed;         ///< what the noise depends on beside them.
    float middle, perUnit;      ///< Of the texture: the value that becomes 0, and a factor.
    double unitsPerStep;        ///< A step is so many units of the G-buffer's flow.
    double reference;           ///< A vector of this length goes a step; 0: each does.
    double least;               ///< Vectors of at most this length go nowhere.
};

/// How large the finite numbers of a row are.
struct RowScales {
    double longest = 0;                                                                       ///< Vector.
    float lo = std::numeric_limits<float>::max(), hi = std::numeric_limits<float>::lowest();  ///< Of the texture.
};
RowScales scalesOf(const float* u, const float* v, const float* texture, int width);

/// The row as texels of a G-buffer's flow (flow_texel): 0 where a vector is not finite. With more bits (FineFlow) where
/// `fineVectors` is not null.
void packRow(const PlanePixels& pixels, int width, std::uint32_t* row, std::uint32_t* fineVectors,
             std::uint16_t* fineNoise);

/// Which of the neighbours of `row` in the eight directions flow, where it flows itself: linkBit.
void linkRow(const std::uint32_t* above, const std::uint32_t* row, const std::uint32_t* below, int width,
             std::uint8_t* links);

}  // namespace aeolic
