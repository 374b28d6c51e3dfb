#pragma once

#include <algorithm>
#include <cmath>

#include "aeolic/scene_description.h"

/// The last step of even streaks: from each pixel's value the mean of all values around it is taken. There are about
/// ten streaks in 25 x 25 pixels, and their mean is not quite the mean of all noise. So whole patches would be a little
/// darker or lighter, and colours read from them a little wrong. What differs from streak to streak stays.
///
/// The mean goes over a square of pixels, those with flow. Its sum is of whole numbers, so it does not depend on the
/// order, and is the same on every backend and from any number of ranks.
namespace aeolic::flatten {

/// Values are rounded to so many parts of their unit, which is their deviation.
inline constexpr int kPerUnit = 512;
/// The word of the value 0. Words are 16 bits, and 0 stands for no flow.
inline constexpr int kZero = 1 << 15;

/// Brings the contrast back: the mean has 0.28 of a value's deviation where noise is as fine as pixels.
inline constexpr float kGain = 1.04f;

/// Whether these options ask for it.
inline bool wanted(const LicOptions& lic)
{
    return lic.streaks == Streaks::even && lic.method != LicMethod::none;
}

/// How far the square goes beyond its middle. Coarser noise has wider streaks and takes a larger one, but the sums of a
/// larger square than this would not fit into 32 bits.
inline int reachPx(const LicOptions& lic)
{
    constexpr double kLeast = 12, kMost = 48;
    return int(std::lround(std::clamp(kLeast / lic.noiseScale, kLeast, kMost)));
}

}  // namespace aeolic::flatten
