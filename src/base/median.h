#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aeolic {

/// The middle value, of an even number the mean of the middle two; 0 of none.
inline double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace aeolic
