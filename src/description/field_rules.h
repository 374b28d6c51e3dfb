#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace aeolic {

/// What a number may be. `aboveLo`: `lo` itself is refused.
struct NumberRule {
    double lo, hi;
    bool aboveLo = false;

    bool accepts(double value) const { return (aboveLo ? value > lo : value >= lo) && value <= hi; }
};

/// What a text may be; `expected` completes "expected …". No text may hold control characters.
struct TextRule {
    const char* expected;
    bool (*accepts)(std::string_view);
};

/// The names of an enum's values, in their order.
struct EnumRule {
    std::span<const std::string_view> names;
};

/// true | false, on the command line on | off.
struct SwitchRule {};

/// What was expected, in words: "a whole number from 1 to 65536", "one of box, hann".
std::string expectedNumber(const NumberRule& rule, bool whole);
std::string expectedName(const EnumRule& rule);

/// The shortest decimal text that reads back as the same number.
std::string numberText(double value);

/// Text of the user's for a one-line message: in quotes, control characters escaped, the middle of long ones left out.
std::string inQuotes(std::string_view text);

/// The whole of `text` as a number (decimal or scientific; not "nan", "inf" or hexadecimal), or nothing.
std::optional<double> parseNumber(std::string_view text);

/// The value's index in the rule's names, or nothing.
std::optional<int> findName(const EnumRule& rule, std::string_view name);

/// Throw InputError with `where` in front if the value is not what the rule says. checkWhole also refuses fractions.
void checkNumber(const std::string& where, double value, const NumberRule& rule);
void checkWhole(const std::string& where, double value, const NumberRule& rule);
void checkText(const std::string& where, std::string_view text, const TextRule& rule);

}  // namespace aeolic
