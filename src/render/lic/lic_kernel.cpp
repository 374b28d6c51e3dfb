#include "render/lic/lic_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lic/noise.h"
#include "render/lic/phase_mix.h"

namespace aeolic {
namespace {

// The variance that the noise of grains has at a point, as measured on uniform flow.
constexpr double kGrainVariance = 0.0023;

// Heads of streaks lie three deviations above the mean: a little less contrast leaves them room below white.
constexpr double kGrainContrast = 0.8;

double anglePerStep(const KernelModel& kernel)
{
    return std::numbers::pi / (kernel.steps + 0.5);
}

}  // namespace

double KernelModel::weight(int i) const
{
    switch (shape) {
        case Shape::box:
            return 1;
        case Shape::hann:
            return 0.5 + 0.5 * std::cos(anglePerStep(*this) * i - phaseRad);
        case Shape::ramp:
            return 0.5 - 0.5 * i / steps;
        case Shape::wave:
            return 0.5 * std::cos(anglePerStep(*this) * i - phaseRad);
    }
    return 1;
}

KernelModel makeKernelModel(const LicOptions& lic)
{
    using Shape = KernelModel::Shape;
    KernelModel kernel;
    kernel.steps = lic.steps;
    const auto turnTo = [&](double phase) {
        kernel.phaseRad = phase;
        kernel.ofFirst = float(std::cos(phase));
        kernel.ofSecond = float(std::sin(phase));
    };
    if (phase_mix::isComets(lic)) {
        kernel.shape = Shape::wave;
        kernel.meanWeight = 0.5;
        kernel.concentration = 1.5;
        kernel.ofPlain = 0;
        turnTo(lic.phase);
    } else if (lic.style == Style::oriented) {
        kernel.shape = Shape::ramp;
        kernel.meanWeight = 0.5;
        kernel.concentration = 4.0 / 3.0;
        kernel.ofSecond = 1;
    } else if (lic.kernel == Kernel::hann || lic.flow == FlowMotion::loop) {
        kernel.shape = Shape::hann;
        kernel.meanWeight = 0.5;
        kernel.concentration = 1.5;
        turnTo(lic.phase);
    }
    return kernel;
}

int kernelSteps(const LicOptions& asked)
{
    constexpr int kOrientedShare = 6;
    return asked.style == Style::oriented ? std::max(asked.steps / kOrientedShare, 1) : asked.steps;
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

std::vector<Turn> turnsOf(const KernelModel& kernel, float sign)
{
    std::vector<Turn> turns;
    for (int i = 0; kernel.weighted() && i <= kernel.steps; ++i) {
        if (kernel.shape == KernelModel::Shape::ramp) {
            turns.push_back({1, 0, -sign * float(double(i) / kernel.steps), 1});
            continue;
        }
        const double angle = anglePerStep(kernel) * i;
        const float cosine = float(std::cos(angle)), sine = sign * float(std::sin(angle));
        turns.push_back({cosine, -sine, sine, cosine});
    }
    return turns;
}

ContrastModel makeContrastModel(const LicOptions& lic)
{
    // Fitted to the deviation measured on uniform flow, noise scales 0.25 to 4, steps 16 to 512 and up to 8 pixels
    // long, within 10 % (contrast_test.cpp holds it to 15): the grain's correlation length in pixels, and the step's
    // where it skips grains.
    const KernelModel kernel = makeKernelModel(lic);
    const bool isOriented = lic.style == Style::oriented;
    const double spread = kernel.concentration, variance = isOriented ? kGrainVariance : kNoiseSigma * kNoiseSigma;
    const double grain =
        isOriented ? grains::kTexelPx / lic.noiseScale : std::hypot(0.668, 0.952 * std::pow(lic.noiseScale, -1.34));
    const double skipped = (isOriented ? 0.3 : 0.506) * lic.step;
    const double inverseB = variance * std::sqrt(std::hypot(grain * grain, skipped * skipped));
    ContrastModel model{float(1 / (variance * variance)), float(1 / (inverseB * inverseB * spread * spread)),
                        float((isOriented ? kGrainContrast : 1) / kernel.meanWeight)};
    if (kernel.shape == KernelModel::Shape::hann) {
        model.phaseCosine = kernel.ofFirst;
        model.phaseSine = kernel.ofSecond;
        model.perStep = 1.0f / float(lic.steps);
    }
    return model;
}

}  // namespace aeolic
