#pragma once

#include "aeolic/scene_description.h"
#include "render/limits.h"

/// The second, short convolution: even streaks are averaged once more over a few pixels along the flow. Values hardly
/// change along a streak, so streaks stay as they are. The dots go that appear where streamlines converge within less
/// than a pixel, or where interpolated jumps part.
///
/// The taps are the pixels nearest to the straight line through a pixel along its own vector, one in each column, or in
/// each row where the line is steeper. Each is reached over a link from the one before. Integers decide which they are,
/// so they are the same on every backend.
///
/// They are looked up in words: a pixel's value with its links in the eight lowest bits, so one look-up brings both. 16
/// bits of the value's fraction are left.
namespace aeolic::along_flow {

/// The weights of the pixel itself, and of those 1, 2 and 3 pixels to either side.
inline constexpr float kWeights[limits::kAlongRows + 1] = {1.0f, 1.0f, 0.75f, 0.4f};

/// Whether these options ask for it. It would blur the heads of oriented streaks, which tell where the flow goes.
inline bool wanted(const LicOptions& lic)
{
    return lic.streaks == Streaks::even && lic.style == Style::dense && lic.method != LicMethod::none;
}

/// What brings the average back to the contrast that the values had, on uniform flow: the inverse of its deviation.
float gain(const LicOptions& lic);

}  // namespace aeolic::along_flow
