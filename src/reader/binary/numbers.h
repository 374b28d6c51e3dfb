#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace aeolic {

/// How a file keeps a number.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

constexpr std::size_t bytesOf(NumberType type)
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return sizes[std::size_t(type)];
}

/// Reads a number in text as std::from_chars() does, and what else programs write for numbers: "+1", Fortran's "1D-3"
/// and "0.4-102". A number that is too small or too large for `Real` becomes zero or infinity, with its sign.
/// Instantiated for float and double.
template <class Real>
std::from_chars_result readReal(const char* begin, const char* end, Real& value);

/// The real number that the whole text is, as readReal() reads it; none where the text is anything else.
template <class Real>
std::optional<Real> realIn(std::string_view text)
{
    Real number = 0;
    const auto [end, error] = readReal(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// `to.size()` numbers out of `from`, which has as many of `type` and need not be aligned. Numbers that `Number` cannot
/// hold become infinite where it is a floating-point type; whole numbers keep their lowest bits. Instantiated for
/// float, double, std::int8_t, std::int32_t and std::int64_t.
template <class Number>
void convertNumbers(const std::uint8_t* from, NumberType type, bool swapped, std::span<Number> to);

}  // namespace aeolic
