#include "cluster/balance/stripes.h"

#include <algorithm>
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

}  // namespace aeolic
