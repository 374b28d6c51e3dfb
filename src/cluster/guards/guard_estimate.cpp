#include "cluster/guards/guard_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/lic/jump_plan.h"
#include "render/limits.h"

namespace aeolic {

GuardRows BoundReach::rows(const Extent&, int steps) const
{
    const int bound = guardRowsBound(steps, maxStepPx_, 0);
    return {bound, bound};
}

VectorReach::VectorReach(const std::vector<RowFlow>& facts, double flowUnitPx, double maxStepPx, int levels)
    : bound_(maxStepPx), steps_(facts.size())
{
    // A row counts as fast as the fastest around it: limits.h says how far vectors come from.
    const int around = int(std::ceil(limits::kVectorSteps * maxStepPx * limits::kRounded)) + limits::kVectorRows +
                       levels * limits::kLevelRows,
              height = int(facts.size());
    for (int y = 0; y < height; ++y) {
        int units = -1;
        for (int k = std::max(y - around, 0); k <= std::min(y + around, height - 1); ++k) {
            const RowFlow& row = facts[std::size_t(k)];
            if (row.x0 < row.x1) units = std::max(units, int(row.maxUnits));
        }
        steps_[std::size_t(y)] = units >= 0 ? 1.0 / ((units * limits::kRounded + limits::kRoundedUnits) * flowUnitPx)
                                            : std::numeric_limits<double>::infinity();
    }
}

int VectorReach::rowsFrom(int row, int direction, int steps) const
{
    double left = steps;
    int rows = 0;
    for (int y = row; y >= 0 && y < int(steps_.size()) && left > 0; y += direction) {
        const double across = steps_[std::size_t(y)];
        if (std::isinf(across)) break;
        left -= across;
        ++rows;
    }
    return rows + limits::kTapRows;
}

GuardRows VectorReach::rows(const Extent& stripe, int steps) const
{
    const GuardRows bound = bound_.rows(stripe, steps);
    return {std::min(bound.above, rowsFrom(stripe.y0 - 1, -1, steps)),
            std::min(bound.below, rowsFrom(stripe.y1, 1, steps))};
}

}  // namespace aeolic
