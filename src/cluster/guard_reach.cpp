#include "cluster/guard_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aeolic {

GuardRows BoundReach::rows(const Extent&, const TraceReach& reach) const
{
    const int bound = guardRowsBound(reach.steps, maxStepPx_, reach.jumps);
    return {bound, bound};
}

VectorReach::VectorReach(const std::vector<RowFacts>& facts, double flowUnitPx, double maxStepPx)
    : bound_(maxStepPx), steps_(facts.size())
{
    // A step that crosses a row starts at most two step lengths away (Runge-Kutta steps of the hierarchical method are
    // double steps), and its vector is interpolated from one row further. Rounding adds less than half a unit.
    const int around = int(std::ceil(2 * maxStepPx)) + 2, height = int(facts.size());
    for (int y = 0; y < height; ++y) {
        int units = 0;
        for (int k = std::max(y - around, 0); k <= std::min(y + around, height - 1); ++k)
            units = std::max(units, int(facts[std::size_t(k)].maxUnits));
        steps_[std::size_t(y)] = units > 0 ? 1.0 / ((units + 1) * flowUnitPx) : std::numeric_limits<double>::infinity();
    }
}

int VectorReach::rowsFrom(int row, int direction, const TraceReach& reach) const
{
    double left = reach.steps;
    int rows = 0;
    for (int y = row; y >= 0 && y < int(steps_.size()) && left > 0; y += direction) {
        const double steps = steps_[std::size_t(y)];
        if (std::isinf(steps)) break;
        left -= steps;
        ++rows;
    }
    return rows + reach.jumps + kTapRows;
}

GuardRows VectorReach::rows(const Extent& stripe, const TraceReach& reach) const
{
    const GuardRows bound = bound_.rows(stripe, reach);
    return {std::min(bound.above, rowsFrom(stripe.y0 - 1, -1, reach)),
            std::min(bound.below, rowsFrom(stripe.y1, 1, reach))};
}

}  // namespace aeolic
