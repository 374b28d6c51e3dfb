#include "render/lic/jump_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/limits.h"

namespace aeolic {
namespace {

// Steps walked directly before jumps are composed: fewer blur fine contrast, more cost time. Chosen by measurement
// (docs/hierarchical.md).
constexpr int kDirectSteps = 8;
// Storing a level and starting from it costs about as much as this many look-ups, and a little sharpness.
constexpr int kLevelCost = 2;
constexpr int kLargestRadix = 8;

void tryPlans(JumpPlan& plan, int steps, JumpPlan& best)
{
    JumpPlan candidate = plan;
    int left = steps;
    candidate.digits.assign(plan.radix.size() + 1, 0);
    for (std::size_t level = plan.radix.size() + 1; level-- > 0;) {
        candidate.digits[level] = left / candidate.stride(level);
        left %= candidate.stride(level);
    }
    candidate.remainder = left;
    const auto cost = [](const JumpPlan& p) { return p.lookups() + kLevelCost * int(p.radix.size()); };
    if (candidate.digits.back() > 0 && (best.digits.empty() || cost(candidate) < cost(best))) best = candidate;
    if (int(plan.radix.size()) + 1 >= kMostLevels) return;
    for (int r = 2; r <= kLargestRadix; ++r) {
        if (plan.stride(plan.radix.size()) * r > steps) break;
        plan.radix.push_back(r);
        tryPlans(plan, steps, best);
        plan.radix.pop_back();
    }
}

}  // namespace

int JumpPlan::stride(std::size_t level) const
{
    return std::accumulate(radix.begin(), radix.begin() + std::ptrdiff_t(level), direct, std::multiplies<>());
}

int JumpPlan::lookups() const
{
    int count =
        std::accumulate(digits.begin(), digits.end(), 0) - 1 + (remainder > 0);  // The first jump starts on a pixel.
    for (const int r : radix) count += r - 1;
    return count;
}

int JumpPlan::steps() const
{
    int sum = remainder;
    for (std::size_t level = 0; level < digits.size(); ++level) sum += digits[level] * stride(level);
    return sum;
}

int JumpPlan::levelReach(std::size_t level) const
{
    const int joined = level < radix.size() ? (radix[level] - 1) * stride(level) : 0;
    if (digits[level] == 0) return joined;
    // The kernel is walked from the highest level down: steps below this level come after its last jump.
    int walked = steps() - remainder - stride(level);
    for (std::size_t lower = 0; lower < level; ++lower) walked -= digits[lower] * stride(lower);
    return std::max(joined, walked);
}

int JumpPlan::remainderReach() const
{
    return steps() - remainder;
}

int JumpPlan::linkReach(std::size_t level) const
{
    int reach = levelReach(level);
    if (level < radix.size()) reach = std::max(reach, stride(level + 1));
    if (level == 0 && remainder > 0) reach = std::max(reach, remainderReach());
    return reach;
}

JumpPlan planJumps(int steps)
{
    JumpPlan start, best;
    start.direct = std::min(steps, kDirectSteps);
    tryPlans(start, steps, best);
    return best;
}

TraceReach traceReach(const LicOptions& lic)
{
    if (lic.method == LicMethod::none) return {};
    return {lic.steps, lic.method == LicMethod::direct ? 0 : planJumps(lic.steps).levels()};
}

int guardRowsBound(int steps, double maxStepPx, int levels)
{
    return int(std::ceil(double(steps) * maxStepPx * limits::kRounded)) + levels * limits::kLevelRows +
           limits::kTapRows;
}

}  // namespace aeolic
