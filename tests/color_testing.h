#pragma once

/// How different two colours look.

#include <array>
#include <cstdint>

namespace aeolic::testkit {

using Triple = std::array<double, 3>;

/// The bytes R, G, B of a word, from the lowest.
Triple rgbOf(std::uint32_t word);

/// CIELAB, D65, of sRGB bytes.
Triple labOf(const Triple& rgb);

/// Between two colours in CIELAB. Source: Sharma, Wu & Dalal, The CIEDE2000 Color-Difference Formula (2005).
double ciede2000(const Triple& one, const Triple& other);

}  // namespace aeolic::testkit
