#include "render/lic/lic_kernel.h"

#include <cmath>
#include <numbers>

#include "render/lic/noise.h"

namespace aeolic {

double KernelModel::weight(int i) const
{
    double sum = meanWeight;
    for (const double frequency : frequencies) sum += 0.5 * std::cos(frequency * i - phaseRad);
    return sum;
}

KernelModel makeKernelModel(const LicOptions& lic)
{
    KernelModel kernel;
    kernel.steps = lic.steps;
    kernel.phaseRad = lic.phase;
    if (lic.kernel == Kernel::hann) {
        kernel.frequencies = {std::numbers::pi / (lic.steps + 0.5)};
        kernel.meanWeight = 0.5;
        kernel.concentration = 1.5;
    }
    return kernel;
}

KernelWeights makeKernelWeights(const KernelModel& kernel)
{
    KernelWeights weights;
    weights.steps = kernel.steps;
    for (int i = 0; i <= kernel.steps; ++i) {
        weights.forward.push_back(float(kernel.weight(i)));
        weights.backward.push_back(float(kernel.weight(-i)));
    }
    return weights;
}

std::vector<Rotation> rotationsOf(const KernelModel& kernel, float sign)
{
    std::vector<Rotation> rotations;
    for (int i = 0; kernel.waves() && i <= kernel.steps; ++i) {
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
    const double grain = std::hypot(0.668, 0.952 * std::pow(lic.noiseScale, -1.34)), skipped = 0.506 * lic.step;
    const double inverseB = variance * std::sqrt(std::hypot(grain * grain, skipped * skipped));
    return {float(1 / (variance * variance)), float(1 / (inverseB * inverseB * spread * spread)),
            float(1 / kernel.meanWeight)};
}

}  // namespace aeolic
