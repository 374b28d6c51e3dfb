#include "reader/binary/numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace aeolic {

namespace {

/// What std::from_chars() finds too small or too large: 0 or infinity, with its sign.
template <class Real>
Real beyondRange(std::string_view text)
{
    long double wide = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), wide).ec == std::errc{}) return Real(wide);
    const bool tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    return std::copysign(tiny ? Real(0) : std::numeric_limits<Real>::infinity(), text.starts_with('-') ? -1 : 1);
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Fortran writes the exponent as D+02, and as +102 where it has three digits. Gives the same number with an 'e', and
/// its end; nothing where no such exponent stands at `at`. Two numbers without a blank between them are none.
std::optional<std::pair<std::string, const char*>> withExponent(const char* begin, const char* at, const char* end)
{
    const bool isMantissa = std::all_of(begin, at, [](char c) { return isDigit(c) || c == '.' || c == '-'; });
    const char* digits = at;
    if (*digits == 'd' || *digits == 'D') ++digits;
    const bool hasLetter = digits != at;
    if (digits != end && (*digits == '+' || *digits == '-')) ++digits;
    const char* const last = std::find_if_not(digits, end, isDigit);
    if (!isMantissa || last == digits || (!hasLetter && (digits == at || last - digits != 3))) return std::nullopt;
    const bool negative = digits[-1] == '-';
    return std::pair(std::string(begin, at) + (negative ? "e-" : "e") + std::string(digits, last), last);
}

}  // namespace

template <class Real>
std::from_chars_result readReal(const char* begin, const char* end, Real& value)
{
    if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
    auto read = std::from_chars(begin, end, value);
    if (read.ec == std::errc::result_out_of_range) {
        value = beyondRange<Real>({begin, read.ptr});
        read.ec = {};
    } else if (read.ec == std::errc{} && read.ptr != end) {
        if (const auto fortran = withExponent(begin, read.ptr, end)) {
            const char* const last = fortran->first.data() + fortran->first.size();
            return {fortran->second, readReal(fortran->first.data(), last, value).ec};
        }
    }
    return read;
}

template std::from_chars_result readReal(const char*, const char*, float&);
template std::from_chars_result readReal(const char*, const char*, double&);

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
    constexpr void (*convert[])(const std::uint8_t*, bool, std::span<Number>) = {
        convertFrom<std::int8_t>,  convertFrom<std::uint8_t>,  convertFrom<std::int16_t>, convertFrom<std::uint16_t>,
        convertFrom<std::int32_t>, convertFrom<std::uint32_t>, convertFrom<std::int64_t>, convertFrom<std::uint64_t>,
        convertFrom<float>,        convertFrom<double>};
    convert[std::size_t(type)](from, swapped, to);
}

template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<float>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<double>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<std::int8_t>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<std::int32_t>);
template void convertNumbers(const std::uint8_t*, NumberType, bool, std::span<std::int64_t>);

}  // namespace aeolic
