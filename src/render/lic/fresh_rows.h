#pragma once

#include <algorithm>

#include "base/extent.h"
#include "base/image.h"
#include "render/lic/jump_plan.h"
#include "render/lic/near_flow.h"

namespace aeolic {

/// Which rows of an image are not as they were at the last call. A window that goes down a large plane (Image::roll)
/// keeps the rows above, and all that follows from them alone.
class FreshRows {
public:
    /// All of them.
    FreshRows() = default;
    /// From row `first` on. No step is longer than `maxStepPx`.
    FreshRows(int first, double maxStepPx) : all_(false), first_(first), maxStepPx_(maxStepPx) {}

    /// The first row of `valid` whose jump of `steps` steps, with so many levels below it, may have changed.
    int changedFrom(int steps, int levels, const Extent& valid) const
    {
        return all_ ? valid.y0 : std::max(first_ - rowsRead(steps, levels), valid.y0);
    }
    /// The first row that the jumps of those rows are computed from. Rows before need no memory.
    int readFrom(int steps, int levels, const Extent& valid) const
    {
        return all_ ? valid.y0 : std::max(changedFrom(steps, levels, valid) - rowsRead(steps, levels), valid.y0);
    }
    /// Makes `valid` the extent of an image whose rows from `first` on are read. Those that are not fresh stay.
    template <class T>
    void prepare(Image<T>& image, const Extent& valid, int first) const
    {
        if (all_)
            image.resize(valid);
        else
            image.roll(valid, first);
    }

private:
    int rowsRead(int steps, int levels) const
    {
        return std::max(guardRowsBound(steps, maxStepPx_, levels), NearFlow::kRows);
    }

    bool all_ = true;
    int first_ = 0;
    double maxStepPx_ = 0;
};

}  // namespace aeolic
