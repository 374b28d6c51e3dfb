#include "base/half.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/parallel.h"

namespace aeolic {

namespace {

constexpr std::uint16_t quietNan = 0x7e00, largestHalf = 0x7bff;
constexpr std::size_t grain = std::size_t{1} << 16;

/// By one thread. `halves` may be the same memory as `floats`, or lie before it.
std::size_t halvesFromFloats(const void* floats, void* halves, std::size_t count)
{
    const auto* source = static_cast<const char*>(floats);
    auto* target = static_cast<char*>(halves);
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t bits;
        std::memcpy(&bits, source + 4 * i, 4);
        std::uint16_t half = halfFromFloat(std::bit_cast<float>(bits));
        if ((half & 0x7fffu) == 0x7c00u) {
            const bool infinite = (bits & 0x7fffffffu) == 0x7f800000u;
            half = infinite ? quietNan : static_cast<std::uint16_t>((half & 0x8000u) | largestHalf);
            clamped += !infinite;
        }
        std::memcpy(target + 2 * i, &half, 2);
    }
    return clamped;
}

}  // namespace

std::uint16_t halfFromFloat(float value)
{
    constexpr std::uint32_t infinity32 = 255u << 23;
    constexpr std::uint32_t overflow = (127u + 16u) << 23;        // 2^16: above it even rounding down overflows.
    constexpr std::uint32_t smallestNormal = (127u - 14u) << 23;  // 2^-14
    // Adding 0.5 shifts a subnormal's ten bits to the end of the float's mantissa: the adder does the rounding.
    constexpr std::uint32_t shifter = (127u - 1u) << 23;

    std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    bits &= 0x7fffffffu;
    std::uint32_t half;
    if (bits >= overflow)
        half = bits > infinity32 ? quietNan : 0x7c00u;
    else if (bits < smallestNormal)
        half = std::bit_cast<std::uint32_t>(std::bit_cast<float>(bits) + std::bit_cast<float>(shifter)) - shifter;
    else  // Rebias the exponent; the odd bit breaks ties to even. A carry out of the mantissa is the next exponent.
        half = (bits - (112u << 23) + 0xfffu + ((bits >> 13) & 1u)) >> 13;
    return static_cast<std::uint16_t>(half | sign);
}

float floatFromHalf(std::uint16_t half)
{
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t magnitude = half & 0x7fffu;
    if (magnitude >= 0x7c00u) return std::bit_cast<float>(sign | 0x7f800000u | ((magnitude & 0x3ffu) << 13));
    // 2^112 moves the exponent from binary16's bias to binary32's, for subnormals as well.
    const float scaled = std::bit_cast<float>(magnitude << 13) * std::bit_cast<float>((127u + 112u) << 23);
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(scaled) | sign);
}

bool isBeyondHalves(float value)
{
    return std::isfinite(value) && (halfFromFloat(value) & 0x7fffu) == 0x7c00u;
}

std::size_t halvesFromFloatsParallel(const float* floats, std::uint16_t* halves, std::size_t count)
{
    std::atomic<std::size_t> clamped{0};
    parallelRanges(count, grain, [&](std::size_t begin, std::size_t end) {
        clamped += halvesFromFloats(floats + begin, halves + begin, end - begin);
    });
    return clamped;
}

std::size_t convertToHalvesInPlace(void* buffer, std::size_t count)
{
    auto* bytes = static_cast<char*>(buffer);
    // Front to back each half is written over floats already read. Halves [n, 2n) cover floats [n/2, n): all of them
    // are converted once the first n are, so every doubling can run on all threads.
    std::size_t done = std::min(count, grain);
    std::atomic<std::size_t> clamped{halvesFromFloats(bytes, bytes, done)};
    while (done < count) {
        const std::size_t first = done;
        done = std::min(count, 2 * done);
        parallelRanges(done - first, grain, [&](std::size_t begin, std::size_t end) {
            clamped += halvesFromFloats(bytes + 4 * (first + begin), bytes + 2 * (first + begin), end - begin);
        });
    }
    return clamped;
}

}  // namespace aeolic
