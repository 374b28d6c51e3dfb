#include "cluster/stripes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace aeolic {

int Stripes::ownerOf(int row) const
{
    // The last stripe that starts at or above `row`: empty stripes before it start there too, but come earlier.
    return int(std::upper_bound(firstRow.begin(), firstRow.end() - 1, row) - firstRow.begin()) - 1;
}

Stripes equalStripes(int height, int ranks)
{
    Stripes stripes;
    for (int r = 0; r <= ranks; ++r) stripes.firstRow.push_back(int(std::int64_t(height) * r / ranks));
    return stripes;
}

Extent withGuard(const Extent& stripe, const GuardRows& guard, int height)
{
    if (stripe.empty()) return stripe;
    return {stripe.x0, std::max(stripe.y0 - guard.above, 0), stripe.x1, std::min(stripe.y1 + guard.below, height)};
}

int guardRowsBound(int steps, double maxStepPx)
{
    constexpr int kTapAndLinkRows = 2;
    return int(std::ceil(double(steps) * maxStepPx)) + kTapAndLinkRows;
}

}  // namespace aeolic
