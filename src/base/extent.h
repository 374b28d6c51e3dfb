#pragma once

#include <algorithm>

namespace aeolic {

/// A rectangle of pixels in global image coordinates: half-open, origin top left.
/// The project's three words for extents: *whole* (all pixels) contains *valid* (readable here) contains *compute*
/// (written here).
struct Extent {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool empty() const { return x1 <= x0 || y1 <= y0; }
    bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    bool operator==(const Extent&) const = default;
};

/// Rows above and below a stripe that its traces may read (bachthaler2006parallel, section 5.2: the buffer zone).
struct GuardRows {
    int above = 0, below = 0;
    bool operator==(const GuardRows&) const = default;
};

/// `stripe` with its guard rows. They end where the image of `height` rows ends, so the outermost stripes have a guard
/// on one side only. An empty stripe has none.
inline Extent withGuard(const Extent& stripe, const GuardRows& guard, int height)
{
    if (stripe.empty()) return stripe;
    return {stripe.x0, std::max(stripe.y0 - guard.above, 0), stripe.x1, std::min(stripe.y1 + guard.below, height)};
}

/// Rows, half-open.
struct RowSpan {
    int y0 = 0, y1 = 0;
    bool empty() const { return y0 >= y1; }
    bool operator==(const RowSpan&) const = default;
};

/// Columns of a row, half-open.
struct ColumnSpan {
    int x0 = 0, x1 = 0;
    bool empty() const { return x0 >= x1; }
    /// The columns from the first of this span and `other` to the last of them.
    ColumnSpan with(const ColumnSpan& other) const
    {
        if (empty()) return other;
        return other.empty() ? *this : ColumnSpan{std::min(x0, other.x0), std::max(x1, other.x1)};
    }
    bool operator==(const ColumnSpan&) const = default;
};

}  // namespace aeolic
