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
