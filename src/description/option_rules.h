#pragma once

/// What the options of a scene may be, and messages about what they are not.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace aeolic {

/// What a number may be. `aboveLo`: `lo` itself is refused. A slider spans `usualLo` to `usualHi`. `automatic`: the
/// text "auto" stands for a number that is not set.
struct NumberRule {
    double lo, hi;
    bool aboveLo = false;
    double usualLo = lo, usualHi = hi;
    bool automatic = false;

    constexpr NumberRule usually(double from, double to) const { return {lo, hi, aboveLo, from, to, automatic}; }
    constexpr NumberRule orAuto() const { return {lo, hi, aboveLo, usualLo, usualHi, true}; }
    bool accepts(double value) const { return (aboveLo ? value > lo : value >= lo) && value <= hi; }
};

/// What a text may be; `expected` completes "expected …". No text may hold control characters. The page knows `kind`:
/// "text" is any text, "color" is six hexadecimal digits or "transparent".
struct TextRule {
    const char* kind;
    const char* expected;
    bool (*accepts)(std::string_view);
};

/// The names that an enum's values have, in their order, or that a text may be. A text may also be what `others` says
/// in words and `isOther` takes; `pattern` tells the page the same as a regular expression, or is empty where a page
/// may not choose it.
struct NameRule {
    std::span<const std::string_view> names;
    const char* others = "";
    bool (*isOther)(std::string_view) = nullptr;
    const char* pattern = "";
};

/// true | false, on the command line on | off.
struct SwitchRule {};

/// What was expected, in words: "a whole number from 1 to 65536", "one of box, hann".
std::string expectedNumber(const NumberRule& rule, bool whole);
std::string expectedText(const NameRule& rule);
inline std::string expectedText(const TextRule& rule)
{
    return rule.expected;
}

/// The range alone, as in those words: "from 1 to 65536", "above 0, up to 8"; empty where every number will do.
std::string rangeText(const NumberRule& rule);

/// The shortest decimal text that reads back as the same number.
std::string numberText(double value);

/// Such numbers with commas between them.
std::string numbersText(std::span<const double> values);

/// A text of the user's for a one-line message: in quotes, control characters escaped, the middle of a long one left
/// out.
std::string inQuotes(std::string_view text);

/// The whole of `text` as a number (decimal or scientific; not "nan", "inf" or hexadecimal), or nothing.
std::optional<double> parseNumber(std::string_view text);

/// The index of `name` among the rule's names. Throws InputError where the rule does not have it. The message has
/// `where`, `found`, the names and the nearest one.
int indexOfName(const std::string& where, const std::string& found, std::string_view name, const NameRule& rule);

/// Throw InputError with `where` in front if the value is not what the rule says. checkWhole also refuses fractions.
void checkNumber(const std::string& where, double value, const NumberRule& rule);
void checkWhole(const std::string& where, double value, const NumberRule& rule);
void checkText(const std::string& where, std::string_view text, const TextRule& rule);
void checkText(const std::string& where, std::string_view text, const NameRule& rule);

}  // namespace aeolic
