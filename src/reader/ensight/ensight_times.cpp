#include "reader/ensight/ensight_times.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace aeolic {

std::vector<std::string> ensightWords(const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, any = false;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\r';
        if (c == '"') {
            quoted = !quoted;
            any = true;
        } else if (quoted || !blank) {
            word += c;
            any = true;
        } else if (any) {
            words.push_back(word);
            word.clear();
            any = false;
        }
    }
    if (any) words.push_back(word);
    return words;
}

void EnSightTimeText::begin(const std::vector<std::string>& words, const Fail& fail)
{
    const int number = ensightNumber<int>(words.empty() ? "" : words[0]).value_or(0);
    if (number < 1) fail("names no time set", "'time set: N', from 1");
    for (const Set& other : sets_)
        if (other.number == number) fail(fmt::format("has time set {} once more", number), "each set once");
    sets_.push_back({number, {}, 0, 1, {}, {}});
}

void EnSightTimeText::take(const std::string& key, const std::vector<std::string>& words, const Fail& fail)
{
    const auto whole = [&] {
        const auto value = ensightNumber<int>(words.size() == 1 ? words[0] : "");
        if (!value) fail("has no whole number", "'" + key + ": N'");
        return long(*value);
    };
    if (key == "time set") {
        begin(words, fail);
        return;
    }
    if (key.ends_with("file")) fail("names a file of times", "'time values:' in the case file");
    if (sets_.empty()) fail("belongs to no time set", "'time set: N' above it");
    Set& set = sets_.back();
    if (key == "number of steps") {
        const long steps = whole();
        if (steps < 1) fail(fmt::format("says {} steps", steps), "1 or more");
        set.steps = std::size_t(steps);
    } else if (key == "filename start number") {
        set.start = whole();
    } else if (key == "filename increment") {
        set.increment = whole();
    } else if (key == "time values") {
        set.values.insert(set.values.end(), words.begin(), words.end());
    } else if (key == "filename numbers") {
        set.numbers.insert(set.numbers.end(), words.begin(), words.end());
    }
}

EnSightTimes EnSightTimeText::finish(const Set& set, const Fail& fail)
{
    const auto bad = [&](const std::string& found, const std::string& expected) {
        fail(fmt::format("time set {} {}", set.number, found), expected);
    };
    EnSightTimes times{set.number, {}, set.numbers};
    const std::size_t steps = set.steps.value_or(0);
    if (steps == 0) bad("does not say how many steps it has", "'number of steps: N'");
    if (set.values.size() != steps)
        bad(fmt::format("has {} time values", set.values.size()), fmt::format("{}, one for each step", steps));
    for (const std::string& word : set.values) {
        const double value = ensightNumber<double>(word).value_or(std::numeric_limits<double>::quiet_NaN());
        if (!std::isfinite(value)) bad(fmt::format("has the time '{}'", word), "finite numbers");
        if (!times.values.empty() && value <= times.values.back())
            bad(fmt::format("has the time {} after {}", value, times.values.back()), "times that increase");
        times.values.push_back(value);
    }
    if (times.numbers.empty())
        for (std::size_t i = 0; i < steps; ++i)
            times.numbers.push_back(std::to_string(set.start + long(i) * set.increment));
    if (times.numbers.size() != steps)
        bad(fmt::format("has {} filename numbers", times.numbers.size()), fmt::format("{}, one for each step", steps));
    for (const std::string& number : times.numbers)
        if (!ensightNumber<long>(number).has_value() || number[0] == '-')
            bad(fmt::format("has the filename number '{}'", number), "whole numbers from 0");
    return times;
}

std::vector<EnSightTimes> EnSightTimeText::finish(const Fail& fail) const
{
    std::vector<EnSightTimes> all;
    for (const Set& set : sets_) all.push_back(finish(set, fail));
    return all;
}

}  // namespace aeolic
