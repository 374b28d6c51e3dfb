#include "description/option_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace aeolic {

namespace {

void refuseOtherBytes(const std::string& where, std::string_view text)
{
    if (std::any_of(text.begin(), text.end(), isControl))
        throw InputError(where, "found " + inQuotes(text), "text without control characters");
    if (!isUtf8(text)) throw InputError(where, "found " + inQuotes(text), "text in UTF-8");
}

}  // namespace

std::string rangeText(const NumberRule& rule)
{
    if (rule.hi == std::numeric_limits<double>::max())
        return rule.lo == -rule.hi ? "" : fmt::format("{} {}", rule.aboveLo ? "above" : "from", numberText(rule.lo));
    return fmt::format("{} {}{} {}", rule.aboveLo ? "above" : "from", numberText(rule.lo),
                       rule.aboveLo ? ", up to" : " to", numberText(rule.hi));
}

std::string expectedNumber(const NumberRule& rule, bool whole)
{
    const bool endless = rule.hi == std::numeric_limits<double>::max();
    const std::string range = rangeText(rule);
    return std::string(rule.automatic ? "auto or " : "") +
           (whole     ? "a whole number"
            : endless ? "a finite number"
                      : "a number") +
           (range.empty() ? "" : " " + range);
}

std::string expectedText(const NameRule& rule)
{
    return fmt::format("one of {}{}{}", fmt::join(rule.names, ", "), rule.isOther ? ", or " : "", rule.others);
}

std::string numberText(double value)
{
    // fmt writes 1e5 and above with an exponent only from 1e16 on; whole numbers read better without ".0".
    return std::isfinite(value) && value == std::trunc(value) && std::abs(value) < 1e15 ? fmt::format("{:.0f}", value)
                                                                                        : fmt::format("{}", value);
}

std::string numbersText(std::span<const double> values)
{
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ",") + numberText(value);
    return text;
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t longest = 80, kept = 36;
    const auto escaped = [](std::string_view part) {
        std::string out;
        for (char c : part)
            out += isControl(c) ? fmt::format("\\x{:02x}", static_cast<unsigned char>(c)) : std::string(1, c);
        return out;
    };
    if (text.size() <= longest) return "'" + escaped(text) + "'";
    return "'" + escaped(text.substr(0, characterStart(text, kept))) + "…" +
           escaped(text.substr(characterStart(text, text.size() - kept))) + "'";
}

std::optional<double> parseNumber(std::string_view text)
{
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
    const auto value = wholeTextAs<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

int indexOfName(const std::string& where, const std::string& found, std::string_view name, const NameRule& rule)
{
    const auto at = std::find(rule.names.begin(), rule.names.end(), name);
    if (at == rule.names.end()) throw InputError(where, found, expectedText(rule) + didYouMean(name, rule.names));
    return int(at - rule.names.begin());
}

void checkNumber(const std::string& where, double value, const NumberRule& rule)
{
    if (!rule.accepts(value)) throw InputError(where, "found " + numberText(value), expectedNumber(rule, false));
}

void checkWhole(const std::string& where, double value, const NumberRule& rule)
{
    if (!rule.accepts(value) || value != std::trunc(value))
        throw InputError(where, "found " + numberText(value), expectedNumber(rule, true));
}

void checkText(const std::string& where, std::string_view text, const TextRule& rule)
{
    refuseOtherBytes(where, text);
    if (!rule.accepts(text)) throw InputError(where, "found " + inQuotes(text), rule.expected);
}

void checkText(const std::string& where, std::string_view text, const NameRule& rule)
{
    refuseOtherBytes(where, text);
    if (rule.isOther && rule.isOther(text)) return;
    indexOfName(where, "found " + inQuotes(text), text, rule);
}

}  // namespace aeolic
