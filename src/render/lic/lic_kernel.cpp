#include "render/lic/lic_kernel.h"

#include <cmath>
#include <numbers>

#include "render/lic/noise.h"

namespace aeolic {

KernelModel makeKernelModel(const LicOptions& lic)
{
    KernelModel model;
    if (lic.kernel == Kernel::hann) {
        model.frequencies = {std::numbers::pi / (lic.steps + 0.5)};
        model.meanWeight = 0.5;
        model.concentration = 1.5;
    }
    const auto weight = [&](int i) {
        double sum = model.meanWeight;
        for (const double frequency : model.frequencies) sum += 0.5 * std::cos(frequency * i - lic.phaseRad);
        return float(sum);
    };
    model.weights.steps = lic.steps;
    for (int i = 0; i <= lic.steps; ++i) {
        model.weights.forward.push_back(weight(i));
        model.weights.backward.push_back(weight(-i));
    }
    return model;
}

std::vector<Rotation> rotationsOf(const KernelModel& kernel, float sign)
{
    std::vector<Rotation> rotations;
    for (int i = 0; kernel.waves() && i <= kernel.weights.steps; ++i) {
        const double angle = kernel.frequencies.front() * i;
        rotations.push_back({float(std::cos(angle)), sign * float(std::sin(angle))});
    }
    return rotations;
}

ContrastModel makeContrastModel(const LicOptions& lic)
{
    // Fitted to the deviation measured on uniform flow, noise scales 0.25 to 4, steps 16 to 512 and up to 8 pixels
    // long, within 10 % (contrast_test.cpp holds it to 15): the grain's correlation length in pixels, and the step's
    // where it skips grains.
    const KernelModel kernel = makeKernelModel(lic);
    const double spread = kernel.concentration, variance = kNoiseSigma * kNoiseSigma;
    const double grain = std::hypot(0.668, 0.952 * std::pow(lic.noiseScale, -1.34)), skipped = 0.506 * lic.stepPx;
    const double inverseB = variance * std::sqrt(std::hypot(grain * grain, skipped * skipped));
    return {float(1 / (variance * variance)), float(1 / (inverseB * inverseB * spread * spread)),
            float(1 / kernel.meanWeight)};
}

}  // namespace aeolic
