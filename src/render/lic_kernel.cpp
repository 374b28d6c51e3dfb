#include "render/lic_kernel.h"

#include <cmath>
#include <numbers>

namespace aeolic {

double hannFrequency(const LicOptions& lic) { return std::numbers::pi / (lic.steps + 0.5); }

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
    const double sigma = 0.24, correlationPx = 1.9 / lic.noiseScale, spread = lic.kernel == Kernel::box ? 1.0 : 1.5;
    return {float(1 / sigma), float(1 / (spread * correlationPx)), lic.kernel == Kernel::box ? 1.0f : 2.0f};
}

}  // namespace aeolic
