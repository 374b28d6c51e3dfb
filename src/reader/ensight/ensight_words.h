#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace aeolic {

/// The words of a line. Quotes hold blanks together.
std::vector<std::string> ensightWords(const std::string& text);

/// A word that is a number and nothing else.
template <class Number>
std::optional<Number> ensightNumber(const std::string& word)
{
    Number value{};
    const char* begin = word.data() + (!word.empty() && word[0] == '+');
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

}  // namespace aeolic
