#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/extent.h"

namespace aeolic {

/// How the image's rows are split among the ranks (bachthaler2006parallel, section 5.1): rank r convolves and shades
/// rows [firstRow[r], firstRow[r + 1]) in full width. A stripe may be empty: more ranks than rows with content.
struct Stripes {
    std::vector<int> firstRow;  ///< [ranks + 1], ascending from 0 to the image's height. Empty: no partition yet.

    int ranks() const { return firstRow.empty() ? 0 : int(firstRow.size()) - 1; }
    int height() const { return firstRow.empty() ? 0 : firstRow.back(); }
    int rows(int rank) const { return firstRow[std::size_t(rank) + 1] - firstRow[std::size_t(rank)]; }

    /// The stripe of `rank` in an image of `width` columns, in global pixels.
    Extent extent(int rank, int width) const
    {
        return {0, firstRow[std::size_t(rank)], width, firstRow[std::size_t(rank) + 1]};
    }

    /// The rank whose stripe holds `row`, [0, height). Cost: log ranks.
    int ownerOf(int row) const
    {
        // The last stripe that starts at or above `row`: empty stripes before it start there too, but come earlier.
        return int(std::upper_bound(firstRow.begin(), firstRow.end() - 1, row) - firstRow.begin()) - 1;
    }

    bool operator==(const Stripes&) const = default;
};

/// Stripes of equal height, as far as rows can be divided: heights differ by at most one.
inline Stripes equalStripes(int height, int ranks)
{
    Stripes stripes;
    for (int r = 0; r <= ranks; ++r) stripes.firstRow.push_back(int(std::int64_t(height) * r / ranks));
    return stripes;
}

}  // namespace aeolic
