#include "render/lic/lic_kernel.h"

#include <cmath>
#include <numbers>

#include "render/lic/noise.h"

namespace aeolic {

double hannFrequency(const LicOptions& lic)
{
    return std::numbers::pi / (lic.steps + 0.5);
}

KernelWeights makeKernelWeights(const LicOptions& lic)
{
    KernelWeights k;
    k.steps = lic.steps;
    const auto weight = [&](int i) {
        if (lic.kernel == Kernel::box) return 1.0f;
        return float(0.5 * (1 + std::cos(hannFrequency(lic) * i - lic.phaseRad)));
    };
    for (int i = 0; i <= lic.steps; ++i) {
        k.forward.push_back(weight(i));
        k.backward.push_back(weight(-i));
    }
    return k;
}

ContrastModel makeContrastModel(const LicOptions& lic)
{
    // Fitted to the deviation measured on uniform flow, noise scales 0.25 to 4, steps 16 to 512 and up to 8 pixels
    // long, within 10 % (contrast_test.cpp holds it to 15): the grain's correlation length in pixels, and the step's
    // where it skips grains.
    const double spread = lic.kernel == Kernel::box ? 1.0 : 1.5, variance = kNoiseSigma * kNoiseSigma;
    const double grain = std::hypot(0.668, 0.952 * std::pow(lic.noiseScale, -1.34)), skipped = 0.506 * lic.stepPx;
    const double inverseB = variance * std::sqrt(std::hypot(grain * grain, skipped * skipped));
    return {float(1 / (variance * variance)), float(1 / (inverseB * inverseB * spread * spread)),
            lic.kernel == Kernel::box ? 1.0f : 2.0f};
}

}  // namespace aeolic
