#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aeolic {

/// The middle value; the mean of the middle two where their number is even; 0 where there is no value.
inline double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace aeolic
