#pragma once

#include <vector>

#include "aeolic/scene_description.h"
#include "base/image.h"

namespace aeolic {

/// What the LIC stage makes of each pixel: the mean noise along its streamline times the contrast gain. About unit
/// variance, zero mean; 0 where there is no flow.
using LicImage = Image<float>;

/// The convolution kernel, sampled at whole steps: weight(i) for i from -steps to steps.
/// box: 1. hann: (1 + cos(pi i / (steps + 1/2) - phase)) / 2, a bump one kernel long that travels along the streamline
/// as the phase grows and re-enters behind (Cabral & Leedom 1993; Forssell & Cohen 1995).
struct KernelWeights {
    int steps = 0;
    std::vector<float> forward, backward;  ///< [steps + 1]: weights of steps 0 to steps, downstream and upstream.
};
KernelWeights makeKernelWeights(const LicOptions& lic);

/// The Hann kernel's angle per step, radians.
double hannFrequency(const LicOptions& lic);

/// How a trace's samples become its LIC value:
///
///   value = gain(L) * sum(weight_i * ds_i * noise_i) / (L * mean weight),   L = sum(ds_i)
///
/// ds_i is the length of step i in the image. So a step that hardly moves there (towards the viewer, near a sink)
/// hardly counts, instead of painting a whole basin with the noise of one pixel. The average is over what was walked.
/// The gain brings the mean to unit variance. It comes from kernel and noise alone, not from the image: averaged over L
/// pixels, noise of variance 1 / a keeps 1 / b of it per pixel, and gain(L) = (a^2 + (b L / f)^2)^(1/4) meets both
/// ends, where f is how much the kernel's shape concentrates its weight (1 for a box, 3/2 for Hann).
struct ContrastModel {
    float zeroLength;         ///< a^2
    float perLength;          ///< (b / f)^2, pixels^-2
    float inverseMeanWeight;  ///< Box 1, Hann 2.
};

/// The starting pixel's own sample has at least this length: without flow it shows its own noise.
inline constexpr float kShortestOwnPx = 1.0f / 16;

ContrastModel makeContrastModel(const LicOptions& lic);

}  // namespace aeolic
