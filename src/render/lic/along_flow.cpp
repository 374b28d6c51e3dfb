#include "render/lic/along_flow.h"

#include <cmath>
#include <cstdlib>

#include "render/lic/lic_kernel.h"

namespace aeolic::along_flow {
namespace {

// The correlation of two LIC values on one streamline, so many steps apart: what their kernels share.
double correlation(const std::vector<double>& weights, double steps)
{
    double shared = 0, all = 0;
    const int whole = int(std::floor(steps));
    const double part = steps - whole;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto at = [&](int lag) {
            return i + std::size_t(lag) < weights.size() ? weights[i + std::size_t(lag)] : 0.0;
        };
        shared += weights[i] * (at(whole) + part * (at(whole + 1) - at(whole)));
        all += weights[i] * weights[i];
    }
    return shared / all;
}

}  // namespace

float gain(const LicOptions& lic)
{
    const KernelWeights kernel = makeKernelWeights(makeKernelModel(lic));
    std::vector<double> weights(kernel.backward.rbegin(), kernel.backward.rend());
    weights.insert(weights.end(), kernel.forward.begin() + 1, kernel.forward.end());
    double correlations[2 * limits::kAlongRows + 1];
    for (int lag = 0; lag <= 2 * limits::kAlongRows; ++lag)
        correlations[lag] = correlation(weights, lag / double(lic.step));
    double variance = 0, total = 0;
    for (int i = -limits::kAlongRows; i <= limits::kAlongRows; ++i) {
        total += double(kWeights[std::abs(i)]);
        for (int k = -limits::kAlongRows; k <= limits::kAlongRows; ++k)
            variance += double(kWeights[std::abs(i)]) * double(kWeights[std::abs(k)]) * correlations[std::abs(i - k)];
    }
    return float(total / std::sqrt(variance));
}

}  // namespace aeolic::along_flow
