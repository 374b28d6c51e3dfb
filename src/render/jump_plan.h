#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// How much the noise is sharpened before sums of it are interpolated; chosen by measurement (docs/hierarchical.md).
inline constexpr float kHierarchicalSharpness = 0.12f;

/// What sharpening can make of a noise byte needs this many times the range.
inline constexpr float kSharpenedNoiseUnit = 2.0f;

/// A plan has no more levels.
inline constexpr int kMostLevels = 6;

/// How many steps to walk directly and how to compose them to the kernel's length.
struct JumpPlan {
    int direct = 1;           ///< Steps walked one by one: the stride of level 0.
    std::vector<int> radix;   ///< Level i + 1 joins radix[i] jumps of level i.
    std::vector<int> digits;  ///< The kernel's length is digits[i] jumps of each level i, and the remainder.
    int remainder = 0;        ///< Single steps.

    int stride(std::size_t level) const;
    /// Interpolated look-ups per pixel and direction.
    int lookups() const;
    int steps() const;  ///< What the plan is for.
    int levels() const { return int(digits.size()); }
    /// How many steps from their pixel traces look jumps of a level, or of the remainder, up.
    int levelReach(std::size_t level) const;
    int remainderReach() const;
    /// How far they follow links meanwhile: to where jumps joined of that level end, too, and with the lowest level to
    /// where the remainder is looked up.
    int linkReach(std::size_t level) const;
};

/// The cheapest plan for `steps`, counting look-ups and levels.
JumpPlan planJumps(int steps);

/// What says how far traces read from where they start.
struct TraceReach {
    int steps = 0;   ///< Integration steps.
    int levels = 0;  ///< Levels of jumps they take them by: each is interpolated, of jumps from up to a row beside.
};
TraceReach traceReach(const LicOptions& lic);

/// A jump's word beside its displacement; shaders get the same numbers. Halves of words hold displacements and sums.
namespace jump_word {

inline constexpr int kHalfMost = 32767;
inline constexpr std::uint32_t kOpenBit = 1u << 16;   ///< The pixel is open (limits::kOpenRings).
inline constexpr std::uint32_t kAliveBit = 1u << 17;  ///< The trace walked all its steps and may go on.
inline constexpr int kLengthShift = 18;               ///< Above: pixels walked, up to kLengthMost units.
inline constexpr int kLengthMost = (1 << (32 - kLengthShift)) - 1;

}  // namespace jump_word

/// What the fields of a jump of `stride` steps count in. flowUnitPx is the longest step over 2048: such a jump just
/// fits signed 16 bits, and so do the others.
struct JumpUnits {
    float displacementPx, sum, lengthPx;
};
inline JumpUnits jumpUnits(int stride, float flowUnitPx)
{
    const float longestPx = flowUnitPx * 2048.0f * float(stride);
    return {flowUnitPx * float(stride) / 16.0f, longestPx / 256.0f, longestPx / float(jump_word::kLengthMost)};
}

}  // namespace aeolic
