#pragma once

#include <array>
#include <cmath>
#include <numbers>

/// Streaks that flow in a picture that stands (LicOptions::flow). A pixel's value with the Hann kernel is a constant,
/// and a cosine and a sine of the phase. Three phases tell these three numbers, so any other phase is a mixture of the
/// three pictures' values, and the convolutions need not be done again. Where streamlines are cut short the value is
/// divided by a length that depends on the phase, too: the mixture then goes smoothly through the three.
namespace aeolic::phase_mix {

inline constexpr int kPhases = 3;

/// Radians.
inline double phaseOf(int which)
{
    return 2 * std::numbers::pi * which / kPhases;
}

/// How much each of the three counts; 1 in all. `phase`: radians.
inline std::array<float, kPhases> weights(double phase)
{
    std::array<float, kPhases> all;
    for (int i = 0; i < kPhases; ++i) all[std::size_t(i)] = float((1 + 2 * std::cos(phase - phaseOf(i))) / kPhases);
    return all;
}

}  // namespace aeolic::phase_mix
