#include "reader/binary/numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace aeolic {

std::from_chars_result readReal(const char* begin, const char* end, double& value)
{
    auto read = std::from_chars(begin, end, value);
    if (read.ec != std::errc::result_out_of_range) return read;
    long double wide = 0;
    if (std::from_chars(begin, end, wide).ec == std::errc::result_out_of_range) {
        const std::string_view text(begin, std::size_t(read.ptr - begin));
        const bool tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
        wide = tiny ? 0 : HUGE_VALL;
        if (text.starts_with('-')) wide = -wide;
    }
    value = double(wide);
    read.ec = {};
    return read;
}

namespace {

template <class From>
From numberAt(const std::uint8_t* bytes, bool swapped)
{
    std::uint8_t own[sizeof(From)];
    std::memcpy(own, bytes, sizeof own);
    if (swapped) std::reverse(own, own + sizeof own);
    From value;
    std::memcpy(&value, own, sizeof value);
    return value;
}

template <class To, class From>
To converted(From value)
{
    if constexpr (std::is_floating_point_v<From> && std::is_integral_v<To>) {
        // What is no whole number of that width becomes the least, which is no index of anything.
        constexpr double limit = 9.2e18;
        if (!(double(value) > -limit && double(value) < limit)) return std::numeric_limits<To>::min();
        return To(std::int64_t(value));
    } else {
        return To(value);
    }
}

template <class From, class To>
void convertFrom(const std::uint8_t* from, bool swapped, std::span<To> to)
{
    if (std::is_same_v<From, To> && !swapped) {
        if (!to.empty()) std::memcpy(to.data(), from, to.size_bytes());
        return;
    }
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = converted<To>(numberAt<From>(from + i * sizeof(From), swapped));
}

}  // namespace

template <class Number>
void convertNumbers(const std::uint8_t* from, NumberType type, bool swapped, std::span<Number> to)
{
    switch (type) {
        case NumberType::int8:
            return convertFrom<std::int8_t>(from, swapped, to);
        case NumberType::uint8:
            return convertFrom<std::uint8_t>(from, swapped, to);
        case NumberType::int16:
            return convertFrom<std::int16_t>(from, swapped, to);
        case NumberType::uint16:
            return convertFrom<std::uint16_t>(from, swapped, to);
        case NumberType::int32:
            return convertFrom<std::int32_t>(from, swapped, to);
        case NumberType::uint32:
            return convertFrom<std::uint32_t>(from, swapped, to);
        case NumberType::int64:
            return convertFrom<std::int64_t>(from, swapped, to);
        case NumberType::uint64:
            return convertFrom<std::uint64_t>(from, swapped, to);
        case NumberType::float32:
            return convertFrom<float>(from, swapped, to);
        case NumberType::float64:
            return convertFrom<double>(from, swapped, to);
    }
}

template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<float>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<double>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<std::int8_t>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<std::int32_t>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<std::int64_t>);

}  // namespace aeolic
