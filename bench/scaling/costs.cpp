#include "scaling/costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace aeolic {
namespace {

constexpr std::size_t kTerms = 3;
constexpr double kNsPerMs = 1e6;

/// ms = sum of term * coefficient.
struct Observation {
    std::array<double, kTerms> terms{};
    double ms = 0;
};

using Coefficients = std::array<double, kTerms>;

/// Gauss on the normal equations of the terms in use; the others' coefficients are 0.
Coefficients solve(const std::vector<Observation>& observations, const std::array<bool, kTerms>& used)
{
    std::array<std::array<double, kTerms + 1>, kTerms> m{};
    for (const Observation& o : observations) {
        const double weight = o.ms > 0 ? 1 / (o.ms * o.ms) : 0;
        for (std::size_t i = 0; i < kTerms; ++i) {
            for (std::size_t j = 0; j < kTerms; ++j) m[i][j] += weight * o.terms[i] * o.terms[j];
            m[i][kTerms] += weight * o.terms[i] * o.ms;
        }
    }
    for (std::size_t i = 0; i < kTerms; ++i)
        if (!used[i] || !(m[i][i] > 0))
            for (std::size_t j = 0; j <= kTerms; ++j) {
                m[i][j] = i == j ? 1 : 0;
                if (j < kTerms && j != i) m[j][i] = 0;
            }
    for (std::size_t i = 0; i < kTerms; ++i) {
        for (std::size_t k = 0; k < kTerms; ++k) {
            if (k == i || m[i][i] == 0) continue;
            const double factor = m[k][i] / m[i][i];
            for (std::size_t j = i; j <= kTerms; ++j) m[k][j] -= factor * m[i][j];
        }
    }
    Coefficients solution{};
    for (std::size_t i = 0; i < kTerms; ++i)
        if (used[i] && m[i][i] != 0) solution[i] = m[i][kTerms] / m[i][i];
    return solution;
}

/// Leaves out the most negative term until none is.
Coefficients solveNotNegative(const std::vector<Observation>& observations)
{
    std::array<bool, kTerms> used{};
    used.fill(true);
    for (;;) {
        const Coefficients solution = solve(observations, used);
        const auto least = std::size_t(std::min_element(solution.begin(), solution.end()) - solution.begin());
        if (!(solution[least] < 0)) return solution;
        used[least] = false;
    }
}

}  // namespace

MeasuredCosts fitCosts(std::span<const std::vector<RankStats>> frames, int imageWidth)
{
    std::vector<Observation> project, convolve, shade, pack;
    for (const std::vector<RankStats>& frame : frames) {
        for (const RankStats& rank : frame) {
            const double pixels = double(rank.pixels), area = double(rank.rows) * imageWidth;
            const double guardArea = double(rank.guardAbove + rank.guardBelow) * imageWidth;
            if (rank.rows == 0) continue;
            const double drawnAgain = rank.guardPixels > 0 ? guardArea : 0.0;
            project.push_back({{1, pixels + double(rank.guardPixels), area + drawnAgain}, rank.project.busyMs});
            convolve.push_back({{double(rank.guardPixels), pixels, area + guardArea}, rank.convolve.busyMs});
            shade.push_back({{0, 0, area}, rank.shade.busyMs});
            if (rank.rank > 0) pack.push_back({{0, pixels, 0}, rank.gather.busyMs});
        }
    }
    MeasuredCosts costs;
    const Coefficients projectMs = solveNotNegative(project), convolveMs = solveNotNegative(convolve);
    costs.projectFixedMs = projectMs[0];
    costs.projectPixelNs = projectMs[1] * kNsPerMs;
    costs.projectAreaNs = projectMs[2] * kNsPerMs;
    costs.convolveGuardPixelNs = convolveMs[0] * kNsPerMs;
    costs.convolvePixelNs = convolveMs[1] * kNsPerMs;
    costs.convolveAreaNs = convolveMs[2] * kNsPerMs;
    costs.shadePixelNs = solveNotNegative(shade)[2] * kNsPerMs;
    costs.packPixelNs = solveNotNegative(pack)[1] * kNsPerMs;
    return costs;
}

}  // namespace aeolic
