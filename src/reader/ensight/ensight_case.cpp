#include "reader/ensight/ensight_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "aeolic/error.h"
#include "reader/ensight/ensight_times.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

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
            const bool text = std::all_of(line.begin(), line.end(), [](char c) {
                return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\r';
            });
            if (!text) fail("is not text", "an EnSight Gold case file");
            const std::size_t begin = line.find_first_not_of(" \t\r");
            if (begin == std::string::npos || line[begin] == '#') continue;
            take(line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin));
        }
        if (!gold_)
            throw InputError(path_, "its FORMAT is not 'type: ensight gold'",
                             "an EnSight Gold case file (older kinds of EnSight are not read)");
        if (case_.geometry.pattern.empty()) throw InputError(path_, "it names no geometry", "'model:' under GEOMETRY");
        case_.timeSets = times_.finish([this](const std::string& found, const std::string& expected) {
            throw InputError(path_, found, expected);
        });
        requireFiles(case_.geometry);
        for (EnSightVariable& variable : case_.variables) requireFiles(variable.file);
        return case_;
    }

private:
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
        const bool continued = section_ == "TIME" && ensightNumber<double>(ensightWords(line).front()).has_value();
        if (continued) colon = std::string::npos;
        if (colon == std::string::npos && !continued) return;  // Nothing that is known.
        std::string value = line;
        if (!continued) {
            key_.clear();
            for (const std::string& word : ensightWords(line.substr(0, colon)))
                key_ += (key_.empty() ? "" : " ") + word;
            for (char& c : key_)
                if (c >= 'A' && c <= 'Z') c = char(c + 32);
            value = line.substr(colon + 1);
        }
        const std::vector<std::string> words = ensightWords(value);
        if (section_ == "FORMAT" && key_ == "type") gold_ = words == std::vector<std::string>{"ensight", "gold"};
        if (section_ == "GEOMETRY") takeGeometry(words);
        if (section_ == "VARIABLE") takeVariable(words);
        if (section_ == "TIME")
            times_.take(key_, words,
                        [this](const std::string& found, const std::string& expected) { fail(found, expected); });
    }

    void takeGeometry(std::vector<std::string> words)
    {
        if (key_ != "model") return;
        const auto change = std::find(words.begin(), words.end(), "change_coords_only");
        if (change != words.end())
            fail("says change_coords_only", "a whole geometry for each step, or one that does not change");
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
        if (end > 1)
            fail("names a file set", "a file for each step ('*' in its name): several in one file are not read");
        EnSightFile file{words.back(), 0};
        if (file.pattern.empty()) fail("names no file", "the name of a file");
        if (end == 1) {
            const auto set = ensightNumber<int>(words[0]);
            if (!set || *set < 1) fail(fmt::format("names the time set '{}'", words[0]), "its number, from 1");
            file.timeSet = *set;
        }
        return file;
    }

    void requireFiles(EnSightFile& file)
    {
        const bool stars = file.pattern.find('*') != std::string::npos;
        if (stars && file.timeSet == 0 && !case_.timeSets.empty()) file.timeSet = case_.timeSets.front().number;
        const auto set = std::find_if(case_.timeSets.begin(), case_.timeSets.end(),
                                      [&](const EnSightTimes& t) { return t.number == file.timeSet; });
        if ((stars || file.timeSet != 0) && set == case_.timeSets.end())
            throw InputError(path_,
                             fmt::format("'{}' belongs to time set {}, which is not there", file.pattern, file.timeSet),
                             "a time set under TIME");
        const std::vector<double> once{0};
        for (const double time : stars ? set->values : once) {
            const std::string path = case_.fileAt(file, time);
            std::error_code error;
            if (!fs::is_regular_file(path, error))
                throw InputError(path_, fmt::format("it names '{}', which is not there", path),
                                 "a file beside the case");
        }
    }

    std::string path_, section_, key_;
    int line_ = 0;
    bool gold_ = false;
    EnSightCase case_;
    EnSightTimeText times_;
};

}  // namespace

std::vector<double> EnSightCase::times() const
{
    std::set<int> used{geometry.timeSet};
    for (const EnSightVariable& variable : variables) used.insert(variable.file.timeSet);
    std::set<double> all;
    for (const EnSightTimes& set : timeSets)
        if (used.contains(set.number)) all.insert(set.values.begin(), set.values.end());
    return {all.begin(), all.end()};
}

std::string EnSightCase::fileAt(const EnSightFile& file, std::optional<double> time) const
{
    std::string name = file.pattern;
    const std::size_t first = name.find('*');
    if (first != std::string::npos) {
        const auto set = std::find_if(timeSets.begin(), timeSets.end(),
                                      [&](const EnSightTimes& t) { return t.number == file.timeSet; });
        std::size_t step = 0;
        const double at = time ? *time : times().front();
        while (step + 1 < set->values.size() && set->values[step + 1] <= at) ++step;
        const std::size_t stars = name.find_first_not_of('*', first) == std::string::npos
                                      ? name.size() - first
                                      : name.find_first_not_of('*', first) - first;
        std::string number = set->numbers[step];
        if (number.size() < stars) number.insert(0, stars - number.size(), '0');
        name.replace(first, stars, number);
    }
    return (fs::path(folder) / name).string();
}

EnSightCase readEnSightCase(const std::string& path)
{
    return CaseText(path).read();
}

}  // namespace aeolic
