#pragma once

#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The convolution kernel, sampled at whole steps: weight(i) for i = -steps … steps.
/// box: 1. hann: (1 + cos(pi i / (steps + 1/2) - phase)) / 2, a bump one kernel long that travels along the streamline as
/// the phase grows and re-enters behind (Cabral & Leedom 1993; Forssell & Cohen 1995).
struct KernelWeights {
    int steps = 0;
    std::vector<float> forward, backward;  ///< [steps + 1]: weights of steps 0 … steps downstream and upstream.
};
KernelWeights makeKernelWeights(const LicOptions& lic);

/// The gain that brings a trace's mean to unit variance, from the kernel alone (no statistics of the image):
/// noise of deviation s and correlation length l, averaged over L pixels, has the variance s^2 l / (l + L / f), where f is
/// how much the kernel's shape spreads its weight (1 for a box, 3/2 for Hann).
struct ContrastModel {
    float inverseSigma;         ///< 1 / s
    float inverseCorrelationPx; ///< 1 / (f l)
};
ContrastModel makeContrastModel(const LicOptions& lic);

}  // namespace aeolic
