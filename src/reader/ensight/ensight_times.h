#pragma once

#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reader/ensight/ensight_case.h"

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

/// The time sets of a case file, while they are read.
class EnSightTimeText {
public:
    /// Reports a fault: what was found, and what was expected.
    using Fail = std::function<void(const std::string&, const std::string&)>;

    /// A line under TIME. A line of numbers belongs to the `key` above it. `fail` throws.
    void take(const std::string& key, const std::vector<std::string>& words, const Fail& fail);

    /// `fail` throws where a set is not whole, or its times do not increase.
    std::vector<EnSightTimes> finish(const Fail& fail) const;

private:
    struct Set {
        int number = 0;
        std::optional<std::size_t> steps;
        long start = 0, increment = 1;
        std::vector<std::string> values, numbers;
    };
    void begin(const std::vector<std::string>& words, const Fail& fail);
    static EnSightTimes finish(const Set& set, const Fail& fail);

    std::vector<Set> sets_;
};

}  // namespace aeolic
