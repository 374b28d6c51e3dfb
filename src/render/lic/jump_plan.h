#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// How much the noise is sharpened before sums of it are interpolated; chosen by measurement (docs/hierarchical.md).
inline constexpr float kHierarchicalSharpness = 0.12f;

/// Sharpening can make a noise byte this many times as large.
inline constexpr float kSharpenedNoiseUnit = 2.0f;

/// A plan has no more levels.
inline constexpr int kMostLevels = 6;

/// How many steps to walk directly and how to compose them to the kernel's length.
struct JumpPlan {
    int direct = 1;           ///< Steps walked one by one: the stride of level 0.
    std::vector<int> radix;   ///< Level i + 1 joins radix[i] jumps of level i.
    std::vector<int> digits;  ///< The kernel is digits[i] jumps of each level i long,
    int remainder = 0;        ///< and this many single steps more.

    int stride(std::size_t level) const;
    /// Interpolated look-ups per pixel and direction.
    int lookups() const;
    int steps() const;  ///< The length that the plan is for.
    int levels() const { return int(digits.size()); }
    /// How many steps away from its pixel a trace looks up jumps of a level, or the remainder.
    int levelReach(std::size_t level) const;
    int remainderReach() const;
    /// How many steps a trace follows links meanwhile. That is also as far as jumps joined of that level go, and with
    /// the lowest level as far as the remainder is looked up.
    int linkReach(std::size_t level) const;
};

/// The cheapest plan for `steps`, counting look-ups and levels.
JumpPlan planJumps(int steps);

/// How far traces read from where they start.
struct TraceReach {
    int steps = 0;   ///< Integration steps.
    int levels = 0;  ///< Levels of jumps. Each is interpolated between jumps that start up to a row beside.
};
TraceReach traceReach(const LicOptions& lic);

/// The worst case of the paper's s_buffer = n / 2 * v_max * dt: `steps` in each direction (n / 2), none longer than
/// `maxStepPx` pixels but by rounding; and limits::kTapRows for what a pixel reads around itself. Where guard
/// pixels are to walk `levels` levels of jumps here, too, each level takes limits::kLevelRows more.
int guardRowsBound(int steps, double maxStepPx, int levels);

/// A jump's word beside its displacement; shaders get the same numbers. A field that has others below it in the word is
/// read together with them, and rounded with them in mind, because that saves taking them off. The open bit alone is
/// taken off before: it depends on links farther away than traces go, which a rank may not have.
namespace jump_word {

inline constexpr std::uint32_t kOpenBit = 1u << 0;   ///< The pixel is open (limits::kOpenRings).
inline constexpr std::uint32_t kAliveBit = 1u << 1;  ///< The trace walked all its steps and may go on.
inline constexpr int kLengthShift = 2;               ///< Pixels walked, by the tube's width, up to kLengthMost units.
inline constexpr int kSumShift = 12;                 ///< The sum of noise, signed, up to kSumMost units.
inline constexpr int kWidthShift = 24;               ///< The tube's width at the end, kWidthOne units for all of it.
inline constexpr int kLengthMost = (1 << (kSumShift - kLengthShift)) - 1;
inline constexpr int kSumMost = (1 << (kWidthShift - kSumShift - 1)) - 1;
inline constexpr int kWidthOne = (1 << (32 - kWidthShift)) - 1;

inline constexpr int kHalfMost = 32767;  ///< Halves of other words hold displacements, and weighted sums.

}  // namespace jump_word

/// What the fields of a jump of `stride` steps count in. flowUnitPx is the longest step over 2048: such a jump just
/// fits signed 16 bits, and so do the others.
struct JumpUnits {
    float displacementPx, sum, lengthPx, weighted;
};
inline JumpUnits jumpUnits(int stride, float flowUnitPx)
{
    const float longestPx = flowUnitPx * 2048.0f * float(stride);
    return {flowUnitPx * float(stride) / 16.0f, longestPx / 16.0f, longestPx / float(jump_word::kLengthMost),
            longestPx / 256.0f};
}

}  // namespace aeolic
