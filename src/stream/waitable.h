#pragma once

#include <algorithm>
#include <chrono>

namespace aeolic::stream {

/// `time`, or a year where it is longer: much more would overflow a clock that it is added to.
inline std::chrono::milliseconds waitable(std::chrono::milliseconds time)
{
    constexpr std::chrono::milliseconds longest = std::chrono::hours(24 * 365);
    return std::min(time, longest);
}

}  // namespace aeolic::stream
