#include "reader/ensight/ensight_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string_view>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

/// A word that is a number and nothing else.
template <class Number>
std::optional<Number> numberOf(const std::string& word)
{
    return wholeTextAs<Number>(std::string_view(word).substr(word.starts_with('+') ? 1 : 0));
}

class CaseText {
public:
    explicit CaseText(const std::string& path) : path_(path)
    {
        case_.path = path;
        case_.folder = fs::path(path).parent_path().string();
    }

    EnSightCase read()
    {
        std::ifstream file(path_, std::ios::binary);
        for (std::string line; std::getline(file, line);) {
            ++line_;
            const bool text = std::ranges::all_of(
                line, [](char c) { return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\r'; });
            if (!text) fail("is not text", "the text of an EnSight case");
            const std::size_t begin = line.find_first_not_of(" \t\r");
            if (begin == std::string::npos || line[begin] == '#') continue;
            take(line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin));
        }
        if (!gold_ && !case_.isForVtk)
            throw InputError(path_, "its FORMAT is not 'type: ensight' or 'type: ensight gold'",
                             "a case file of EnSight 6 or Gold");
        if (case_.isForVtk) return case_;
        if (case_.geometry.pattern.empty()) throw InputError(path_, "it names no geometry", "'model:' under GEOMETRY");
        for (const TimeSet& set : timeSets_) case_.timeSets.push_back(timesOf(set));
        requireFiles(case_.geometry);
        for (EnSightVariable& variable : case_.variables) requireFiles(variable.file);
        return case_;
    }

private:
    /// What the lines read so far say of a time set.
    struct TimeSet {
        int number = 0;
        std::size_t steps = 0;  // 0: not said yet.
        long start = 0, increment = 1;
        std::vector<std::string> values, numbers;
    };

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const
    {
        throw InputError(path_, fmt::format("line {} {}", line_, found), expected);
    }

    void take(const std::string& line)
    {
        for (const char* name : {"FORMAT", "GEOMETRY", "VARIABLE", "TIME", "FILE", "MATERIAL", "SCRIPTS"})
            if (line == name) {
                section_ = line;
                key_.clear();
                return;
            }
        std::size_t colon = line.find(':');
        const bool continued = section_ == "TIME" && numberOf<double>(ensightWords(line).front()).has_value();
        if (continued) colon = std::string::npos;
        if (colon == std::string::npos && !continued) return;  // Nothing that is known.
        std::string value = line;
        if (!continued) {
            key_.clear();
            for (const std::string& word : ensightWords(line.substr(0, colon)))
                key_ += (key_.empty() ? "" : " ") + word;
            key_ = lowerCase(key_);
            value = line.substr(colon + 1);
        }
        const std::vector<std::string> words = ensightWords(value);
        if (section_ == "FORMAT" && key_ == "type") {
            gold_ = words == std::vector<std::string>{"ensight", "gold"};
            case_.isForVtk = words == std::vector<std::string>{"ensight"};
        }
        if (case_.isForVtk) return;
        if (section_ == "GEOMETRY") takeGeometry(words);
        if (section_ == "VARIABLE") takeVariable(words);
        if (section_ == "FILE" && (key_ == "file set" || key_ == "filename index" || key_ == "number of steps"))
            takeFileSet(words);
        if (section_ == "TIME") takeTimes(words);
    }

    void takeGeometry(std::vector<std::string> words)
    {
        if (key_ != "model") return;
        const auto change = std::ranges::find(words, "change_coords_only");
        if (words.end() - change > 1)
            fail("says change_coords_only with the step that has the cells", "a whole geometry for each step");
        words.erase(change, words.end());
        if (words.empty()) fail("names no file", "'model: [TIME SET] FILE'");
        case_.geometry = fileOf(words, words.size() - 1);
    }

    void takeVariable(const std::vector<std::string>& words)
    {
        const bool vectors = key_.starts_with("vector per "), node = key_.ends_with(" per node");
        if (key_ != "scalar per node" && key_ != "scalar per element" && key_ != "vector per node" &&
            key_ != "vector per element")
            return;
        if (words.size() < 2) fail("names no file", fmt::format("'{}: [TIME SET] NAME FILE'", key_));
        const std::string& name = words[words.size() - 2];
        for (const EnSightVariable& other : case_.variables)
            if (other.name == name && other.onPoints == node)
                fail(fmt::format("names the variable '{}' once more", name), "each variable once");
        case_.variables.push_back({name, node, vectors ? 3 : 1, fileOf(words, words.size() - 2)});
    }

    /// `words` before `end` are the numbers of a time set and a file set.
    EnSightFile fileOf(const std::vector<std::string>& words, std::size_t end) const
    {
        EnSightFile file{words.back()};
        if (file.pattern.empty()) fail("names no file", "the name of a file");
        const auto number = [&](std::size_t i, const char* what) {
            const auto set = numberOf<int>(words[i]);
            if (!set || *set < 1) fail(fmt::format("names the {} '{}'", what, words[i]), "its number, from 1");
            return *set;
        };
        if (end > 0) file.timeSet = number(0, "time set");
        if (end > 1) file.fileSet = number(1, "file set");
        return file;
    }

    int wholeOf(const std::vector<std::string>& words, int least = std::numeric_limits<int>::min()) const
    {
        const auto whole = numberOf<int>(words.size() == 1 ? words[0] : "");
        if (!whole || *whole < least) fail("has no whole number", "'" + key_ + ": N'");
        return *whole;
    }

    /// A line of numbers belongs to the key above it.
    void takeTimes(const std::vector<std::string>& words)
    {
        if (key_ == "time set") {
            const int number = numberOf<int>(words.empty() ? "" : words[0]).value_or(0);
            if (number < 1) fail("names no time set", "'time set: N', from 1");
            for (const TimeSet& other : timeSets_)
                if (other.number == number) fail(fmt::format("has time set {} once more", number), "each set once");
            timeSets_.push_back({number, 0, 0, 1, {}, {}});
            return;
        }
        if (key_.ends_with("file")) fail("names a file of times", "'time values:' in the case file");
        if (timeSets_.empty()) fail("belongs to no time set", "'time set: N' above it");
        TimeSet& set = timeSets_.back();
        if (key_ == "number of steps") {
            const int steps = wholeOf(words);
            if (steps < 1) fail(fmt::format("says {} steps", steps), "1 or more");
            set.steps = std::size_t(steps);
        } else if (key_ == "filename start number") {
            set.start = wholeOf(words);
        } else if (key_ == "filename increment") {
            set.increment = wholeOf(words);
        } else if (key_ == "time values") {
            set.values.insert(set.values.end(), words.begin(), words.end());
        } else if (key_ == "filename numbers") {
            set.numbers.insert(set.numbers.end(), words.begin(), words.end());
        }
    }

    /// Throws where the set is not whole, or its times do not increase.
    EnSightTimes timesOf(const TimeSet& set) const
    {
        const auto bad = [&](const std::string& found, const std::string& expected) {
            throw InputError(path_, fmt::format("time set {} {}", set.number, found), expected);
        };
        EnSightTimes times{set.number, {}, set.numbers};
        if (set.steps == 0) bad("does not say how many steps it has", "'number of steps: N'");
        const std::string each = fmt::format("{}, one for each step", set.steps);
        if (set.values.size() != set.steps) bad(fmt::format("has {} time values", set.values.size()), each);
        for (const std::string& word : set.values) {
            const double value = numberOf<double>(word).value_or(std::numeric_limits<double>::quiet_NaN());
            if (!std::isfinite(value)) bad(fmt::format("has the time '{}'", word), "finite numbers");
            if (!times.values.empty() && value <= times.values.back())
                bad(fmt::format("has the time {} after {}", value, times.values.back()), "times that increase");
            times.values.push_back(value);
        }
        if (times.numbers.empty())
            for (std::size_t i = 0; i < set.steps; ++i)
                times.numbers.push_back(std::to_string(set.start + long(i) * set.increment));
        if (times.numbers.size() != set.steps) bad(fmt::format("has {} filename numbers", times.numbers.size()), each);
        for (const std::string& number : times.numbers)
            if (!numberOf<long>(number).has_value() || number[0] == '-')
                bad(fmt::format("has the filename number '{}'", number), "whole numbers from 0");
        return times;
    }

    void takeFileSet(const std::vector<std::string>& words)
    {
        const int whole = wholeOf(words, key_ == "file set" ? 1 : 0);
        std::vector<EnSightFileSet>& sets = case_.fileSets;
        if (key_ == "file set")
            sets.push_back({whole, {}});
        else if (sets.empty())
            fail("belongs to no file set", "'file set: N' above it");
        else if (key_ == "filename index")
            sets.back().files.push_back({words[0], 0});
        else if (sets.back().files.empty() || sets.back().files.back().count > 0)
            sets.back().files.push_back({"", std::size_t(whole)});
        else
            sets.back().files.back().count = std::size_t(whole);
    }

    void requireFiles(EnSightFile& file)
    {
        const bool stars = file.pattern.find('*') != std::string::npos || file.fileSet != 0;
        if (stars && file.timeSet == 0 && !case_.timeSets.empty()) file.timeSet = case_.timeSets.front().number;
        const auto set =
            std::ranges::find_if(case_.timeSets, [&](const EnSightTimes& t) { return t.number == file.timeSet; });
        if ((stars || file.timeSet != 0) && set == case_.timeSets.end())
            throw InputError(path_,
                             fmt::format("'{}' belongs to time set {}, which is not there", file.pattern, file.timeSet),
                             "a time set under TIME");
        if (file.fileSet != 0) requireSteps(file, set->values.size());
        const std::vector<double> once{0};
        for (const double time : stars ? set->values : once) {
            const std::string path = case_.placeAt(file, time).path;
            std::error_code error;
            if (!fs::is_regular_file(path, error))
                throw InputError(path_, fmt::format("it names '{}', which is not there", path),
                                 "a file beside the case");
        }
    }

    void requireSteps(const EnSightFile& file, std::size_t steps) const
    {
        std::size_t there = 0;
        if (const EnSightFileSet* set = case_.fileSet(file.fileSet))
            for (const EnSightFileSet::Steps& each : set->files) there += each.count;
        if (there < steps)
            throw InputError(path_, fmt::format("file set {} of '{}' has {} steps", file.fileSet, file.pattern, there),
                             fmt::format("{}, as the time set has", steps));
    }

    std::string path_, section_, key_;
    int line_ = 0;
    bool gold_ = false;
    EnSightCase case_;
    std::vector<TimeSet> timeSets_;
};

}  // namespace

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

std::vector<double> EnSightCase::times() const
{
    std::set<int> used{geometry.timeSet};
    for (const EnSightVariable& variable : variables) used.insert(variable.file.timeSet);
    std::set<double> all;
    for (const EnSightTimes& set : timeSets)
        if (used.contains(set.number)) all.insert(set.values.begin(), set.values.end());
    return {all.begin(), all.end()};
}

const EnSightFileSet* EnSightCase::fileSet(int number) const
{
    const auto set = std::ranges::find_if(fileSets, [&](const EnSightFileSet& each) { return each.number == number; });
    return set == fileSets.end() ? nullptr : &*set;
}

EnSightPlace EnSightCase::placeAt(const EnSightFile& file, std::optional<double> time) const
{
    std::string name = file.pattern;
    const std::size_t first = name.find('*');
    if (first == std::string::npos && file.fileSet == 0) return {(fs::path(folder) / name).string(), {}};
    const auto times = std::ranges::find_if(timeSets, [&](const EnSightTimes& t) { return t.number == file.timeSet; });
    std::size_t step = 0;
    const double at = time ? *time : this->times().front();
    while (step + 1 < times->values.size() && times->values[step + 1] <= at) ++step;
    std::string number = times->numbers[step];
    if (file.fileSet != 0) {
        auto steps = fileSet(file.fileSet)->files.begin();
        for (; step >= steps->count; ++steps) step -= steps->count;
        number = steps->index;
    }
    if (first != std::string::npos) {
        const std::size_t end = std::min(name.find_first_not_of('*', first), name.size());
        if (number.size() < end - first) number.insert(0, end - first - number.size(), '0');
        name.replace(first, end - first, number);
    }
    return {(fs::path(folder) / name).string(), file.fileSet == 0 ? std::nullopt : std::optional(step)};
}

EnSightCase readEnSightCase(const std::string& path)
{
    return CaseText(path).read();
}

}  // namespace aeolic
