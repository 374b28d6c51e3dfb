#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

#include "aeolic/scene_description.h"
#include "render/lic/noise.h"

/// Streaks that flow (LicOptions::flow). A few convolutions tell the values of all phases, so in a picture that stands
/// they are done once.
///
/// Dense streaks: a pixel's value with the Hann kernel is a constant, and a cosine and a sine of the phase. Three
/// phases tell these three numbers, so any other phase is a mixture of the three pictures' values. Where streamlines
/// are cut short the value is divided by a length that depends on the phase, too: the mixture then goes smoothly
/// through the three.
///
/// Oriented streaks: each grain has a phase of its own, or else all streaks would begin and end at once (Wegenkittl,
/// Gröller and Purgathofer 1997). Convolved with a wave as long as the streak, all grains that a pixel sees make one
/// number of the complex plane. Its length tells how bright a streak is there, its angle where along the streak the
/// pixel lies. Four convolutions tell it. A comet runs through all angles: it grows brighter downstream, to its head,
/// and is dark ahead.
namespace aeolic::phase_mix {

inline constexpr int kPhases = 3;

/// Radians.
inline double phaseOf(int which)
{
    return 2 * std::numbers::pi * which / kPhases;
}

/// How much each of the three counts; 1 in all. `phase`: radians.
using Weights = std::array<float, kPhases>;
inline Weights weights(double phase)
{
    Weights all;
    for (int i = 0; i < kPhases; ++i) all[std::size_t(i)] = float((1 + 2 * std::cos(phase - phaseOf(i))) / kPhases);
    return all;
}

/// A frame's phase, by which comets are turned.
struct Turned {
    float cosine, sine;
};
/// Asks for the mean of all phases, which is no picture of comets but is kept for those.
struct MeanOfComets {};

/// A comet along its streak, which is one turn long: factors of the cosines and sines of one, two and three times the
/// angle, less the mean. The head is at half a turn. It is the square of a ramp, without its higher harmonics and most
/// of their ripples (roots of Lanczos's factors): eight pictures tell all that lie between (web/picture/cycle.js), and
/// they hold three harmonics.
struct Comet {
    static constexpr std::array<float, 3> kCosine{-0.09614f, 0.02021f, -0.00617f}, kSine{0.30203f, -0.12699f, 0.05813f};
    /// A pixel's value is the streak's brightness times kContrast times the comet, and the mean of all phases: the
    /// streak's brightness times kMean, less kTakenOff, its mean over all pixels by measurement.
    static constexpr float kContrast = 2.8f, kMean = 2.8f / 3, kTakenOff = 0.52f;
};

/// Whether these options draw comets.
inline bool isComets(const LicOptions& lic)
{
    return lic.flow == FlowMotion::loop && lic.style == Style::oriented;
}

/// What makes a frame's values of those that are kept.
using Mixture = std::variant<Weights, Turned, MeanOfComets>;
Mixture mixtureOf(const LicOptions& lic);

/// A convolution whose values are kept.
struct Run {
    GrainValue grains;
    double phase;  ///< Of the kernel, radians.
};
inline constexpr int kMostRuns = 4;
/// Comets' mean of all phases is kept, too, with the means around taken off (flatten.h): so no patch is darker.
inline constexpr int kMeanOfComets = kMostRuns, kMostKept = kMostRuns + 1;
/// Those of which a frame with these options is mixed: in the order in which they are kept.
std::span<const Run> runsOf(const LicOptions& lic);

}  // namespace aeolic::phase_mix
