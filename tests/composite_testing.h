#pragma once

#include <algorithm>
#include <vector>

#include "base/extent.h"

namespace aeolic::testkit {

/// The rows that ranks need of a picture: stripes with a row of the neighbours on each side; rank 1's is empty.
inline std::vector<Extent> overlappingRows(int ranks, int width, int height)
{
    std::vector<Extent> rows;
    for (int r = 0; r < ranks; ++r) {
        const int y0 = height * r / ranks, y1 = height * (r + 1) / ranks;
        rows.push_back(r == 1 ? Extent{0, y0, width, y0}
                              : Extent{0, std::max(y0 - 1, 0), width, std::min(y1 + 1, height)});
    }
    return rows;
}

}  // namespace aeolic::testkit
