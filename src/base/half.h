#pragma once

#include <cstddef>
#include <cstdint>

namespace aeolic {

inline constexpr int kLargestHalf = 65504;

/// IEEE 754 binary16 from binary32, round to nearest, ties to even. Overflow gives infinity, NaN the quiet NaN 0x7e00
/// with its sign; subnormal halves are exact.
std::uint16_t halfFromFloat(float value);

/// Whether a value is finite and yet rounds to infinity as a half.
bool isBeyondHalves(float value);

/// Every half is exact as a float.
float floatFromHalf(std::uint16_t half);

/// Converts `count` floats to halves, on all threads. What would overflow becomes +-65504, the largest half; infinities
/// and NaN become NaN, the mask. Returns how many were clamped. The memory of `halves` and `floats` must not overlap.
std::size_t halvesFromFloatsParallel(const float* floats, std::uint16_t* halves, std::size_t count);

/// Converts a buffer of `count` floats to halves in place, on all threads. Its first 2 * `count` bytes hold them
/// afterwards. Values, and what is returned, are as of halvesFromFloatsParallel(). No memory is needed beside the
/// buffer, so a field that just fits as floats can still become halves.
std::size_t convertToHalvesInPlace(void* buffer, std::size_t count);

}  // namespace aeolic
