#pragma once

#include <algorithm>

#include "base/extent.h"

namespace aeolic {

/// Rows beyond a stripe that its traces may read (bachthaler2006parallel, section 5.2: the buffer zone).
struct GuardRows {
    int above = 0, below = 0;
    bool operator==(const GuardRows&) const = default;
};

/// `stripe` with its guard rows, ending where the image of `height` rows ends: the outermost stripes have a guard on
/// one side only, and an empty stripe has none.
inline Extent withGuard(const Extent& stripe, const GuardRows& guard, int height)
{
    if (stripe.empty()) return stripe;
    return {stripe.x0, std::max(stripe.y0 - guard.above, 0), stripe.x1, std::min(stripe.y1 + guard.below, height)};
}

}  // namespace aeolic
