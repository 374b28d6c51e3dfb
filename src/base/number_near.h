#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace aeolic {

/// A number among others that lie within `size`, with that many digits of it: coordinates of maps have many more digits
/// than the data are wide. Where `size` is 0, all digits that tell it from its neighbours.
inline std::string numberNear(double value, double size, int digits)
{
    if (!(size > 0) || !std::isfinite(value)) return fmt::format("{}", value);
    const double more = std::ceil(std::log10(std::max(1.0, std::abs(value) / size)));
    return more > 17 - digits ? fmt::format("{}", value) : fmt::format("{:.{}g}", value, digits + int(more));
}

}  // namespace aeolic
