#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "aeolic/scene_description.h"
#include "base/large_memory.h"
#include "description/camera.h"

namespace aeolic {

/// The LIC's noise: a solid texture in P-space, so streaks stick to the surface (paper, section 3; Weiskopf & Ertl
/// 2004).
///
/// One tileable 64^3 tile of white noise serves every MIP level o: there its texel is base * 2^o wide. Two neighbouring
/// levels, chosen by the pixel's footprint, are blended so that the grain stays about a pixel wide at any distance and
/// zoom and never pops. A level is not the average of the finer one: every level has full contrast. The tile is rotated
/// against the world's axes, so a plane cuts it without repeating (docs/decisions/0004-noise.md).
///
/// Oriented streaks have grains instead: of the texels few are white, no two of them neighbours, so that grains lie
/// evenly. Interpolation makes a ball of each, which the surface cuts (docs/decisions/0033-oriented-streaks.md).
struct NoisePyramid {
    static constexpr int kSize = 64;               ///< Texels per side; a power of two.
    static constexpr double kTexelPerPixel = 1.0;  ///< Width of the coarser blended texel at full blend, in pixels.

    /// Texels are black or white, -1 or 1. Bit c of cell (x, y, z) is the texel at (x + (c & 1), y + (c >> 1 & 1),
    /// z + (c >> 2)), so one fetch brings a whole trilinear cell, and the tile takes 256 KB. There are kPadding bytes
    /// more, because a fetch may read a word.
    LargeVector<std::uint8_t> cells;
    static constexpr std::size_t kPadding = 3;
    Style style = Style::dense;
    std::uint32_t seed = 0;

    /// Where the cell at (x, y, z) is, each within [0, kSize).
    static std::size_t index(std::size_t x, std::size_t y, std::size_t z) { return (z * kSize + y) * kSize + x; }

    explicit NoisePyramid(std::uint32_t seed, Style style = Style::dense);
};

/// What a white texel of the tile stands for. none: noise, as a black one does. height: a grain. cosine and sine: a
/// grain's height times the cosine or the sine of its phase (grains::phaseOf()), of which comets are made
/// (phase_mix.h).
enum class GrainValue : std::uint32_t { none, height, cosine, sine };

/// How a pixel looks its noise up; one for the whole frame.
struct NoiseLookup {
    glm::dmat3 texelFromLocal{1};   ///< Rotation and scale: local P-space to texels of level 0.
    double levelFromFootprint = 1;  ///< footprint (world) * this = the value whose power-of-two exponent is the level.
    GrainValue grains = GrainValue::none;
};

/// `sceneDiagonal` fixes the size of level 0, so the noise keeps its place with any camera and image size.
NoiseLookup makeNoiseLookup(double sceneDiagonal, double noiseScale, Style style = Style::dense);

/// Grains, as the LIC stage needs them: a texel of the tile's is 1 or 0, and their mean is taken off, so that neither
/// many nor few of them make a patch lighter or darker. What a streamline crosses of a grain grows with its size in the
/// image, so its height falls with that: grains of either level make streaks that are equally bright.
namespace grains {

/// Width of a texel in pixels, where the coarser level alone is left and the next one begins. By measurement:
/// streaks tell best where they lead (decision 0033).
inline constexpr double kTexelPx = 2.5;
/// The least distance of two grains in the tile, texels, squared.
inline constexpr int kApart2 = 9;
/// The share of the tile's texels that are grains: how many that leaves room for, for any seed within 1 %.
inline constexpr float kShare = 0.0265f;
/// Levels are blended in the middle third of an octave alone: two populations of grains at once are twice as many. In
/// parts of where the finer level's texels have kTexelPx.
inline constexpr float kBlendFrom = 1.26f, kBlendTo = 1.587f;
/// Height of a grain in the finer level where m is 1; in the coarser level half of that.
inline constexpr float kHeight = 0.5f;

/// A grain has one of these phases, a sixteenth of a turn apart. These are their cosines; the sine of a phase is the
/// cosine of a quarter of a turn before.
inline constexpr int kPhases = 16;
inline constexpr std::array<float, kPhases> kWave{
    1.0f,  0.92387953f,  0.70710678f,  0.38268343f,  0.0f, -0.38268343f, -0.70710678f, -0.92387953f,
    -1.0f, -0.92387953f, -0.70710678f, -0.38268343f, 0.0f, 0.38268343f,  0.70710678f,  0.92387953f};
inline constexpr std::uint32_t kHashFirst = 0x9E3779B1u, kHashSecond = 0x85EBCA77u;
/// The phase of the grain in a texel, `texel` being its NoisePyramid::index(): four bits of a hash.
constexpr std::uint32_t phaseOf(std::uint32_t texel)
{
    const std::uint32_t hash = texel * kHashFirst;
    return ((hash ^ (hash >> 15)) * kHashSecond) >> 28;
}

}  // namespace grains

/// Offset of level o's tile, in texels: neighbouring levels must not show the same pattern.
inline constexpr std::array<double, 3> kNoiseLevelOffset{19.137, 41.713, 7.391};

/// Standard deviation of the noise (range -1 … 1) at a point, averaged over positions within a texel. A texel has 1;
/// trilinear interpolation of independent texels keeps (2/3)^3 of the variance.
inline constexpr double kNoiseSigma = 0.5443;

}  // namespace aeolic
