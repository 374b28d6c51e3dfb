#include "data/load/series/time_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/named_file.h"
#include "data/reading/file_questions.h"
#include "data/series_entry.h"

namespace aeolic {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t mostDigits = 18;  // So many fit into 64 bits.

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// A file name around its wildcard.
struct Pattern {
    std::string before, after;
    std::size_t width = 0;  ///< Digits a shorter number is padded to; 0: any width.
    bool another = false;   ///< A second wildcard follows.
};

/// Where a wildcard begins and ends in `name`, from `start` on.
std::optional<Pattern> findWildcard(const std::string& name, std::size_t start = 0)
{
    for (std::size_t at = start; at < name.size(); ++at) {
        std::size_t end = at + 1, width = 0;
        if (name[at] == '%') {
            while (end < name.size() && isDigit(name[end]) && width < 100)
                width = 10 * width + std::size_t(name[end++] - '0');
            if (end == name.size() || name[end] != 'd') continue;
            ++end;
        } else if (name[at] != '*') {
            continue;
        }
        return Pattern{name.substr(0, at), name.substr(end), width, findWildcard(name, end).has_value()};
    }
    return std::nullopt;
}

/// The number in `name`, where it has the pattern's shape.
std::optional<std::int64_t> numberIn(const std::string& name, const Pattern& pattern)
{
    if (name.size() <= pattern.before.size() + pattern.after.size() || !name.starts_with(pattern.before) ||
        !name.ends_with(pattern.after))
        return std::nullopt;
    const std::string digits =
        name.substr(pattern.before.size(), name.size() - pattern.before.size() - pattern.after.size());
    if (digits.size() > mostDigits || !std::ranges::all_of(digits, isDigit)) return std::nullopt;
    const bool padded = digits.size() > 1 && digits.front() == '0';
    if (pattern.width > 0 && (digits.size() < pattern.width || (padded && digits.size() > pattern.width)))
        return std::nullopt;
    std::int64_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

/// Whether the file name holds a wildcard for numbers (%d, %04d or *) and no file has this very name.
bool isNumberPattern(const std::string& path)
{
    std::error_code error;
    return findWildcard(fs::path(path).filename().string()) && !fs::exists(path, error);
}

/// The files whose names have a number where the pattern has its wildcard, in the order of the numbers, timed 0, 1, 2 …
/// `*` and `%d` take a number of any width, `%04d` one padded with zeros to at least four digits. Throws for a pattern
/// with two wildcards, without any such file, and where two files have the same number.
std::vector<SeriesEntry> numberedFiles(const std::string& path)
{
    const auto pattern = findWildcard(fs::path(path).filename().string());
    if (!pattern || pattern->another)
        throw InputError(path, pattern ? "two wildcards" : "no wildcard", "one, for the number: %d, %04d or *");
    const fs::path folder = fs::path(path).parent_path();
    std::vector<std::pair<std::int64_t, std::string>> found;
    std::error_code error;
    for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (const auto number = numberIn(name, *pattern)) found.emplace_back(*number, name);
    }
    if (error)
        throw InputError(path, fmt::format("its folder cannot be read ({})", error.message()), "a folder of files");
    if (found.empty())
        throw InputError(path, "no file has such a name",
                         fmt::format("files like {}{:0{}}{}", pattern->before, 0,
                                     std::max<std::size_t>(1, pattern->width), pattern->after));
    std::ranges::sort(found);
    std::vector<SeriesEntry> entries;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i > 0 && found[i].first == found[i - 1].first)
            throw InputError(path,
                             fmt::format("'{}' and '{}' have the same number", found[i - 1].second, found[i].second),
                             "one file for each number");
        entries.push_back({(folder / found[i].second).string(), double(i)});
    }
    return entries;
}

bool isList(const std::string& path)
{
    const FileKind* kind = fileKindOf(path);
    return kind && kind->use == FileUse::list;
}

void checkTimes(const std::string& path, const std::vector<SeriesEntry>& entries)
{
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const SeriesEntry& entry = entries[i];
        if (!std::isfinite(entry.time))
            throw InputError(path, fmt::format("'{}' has time {}", entry.file, entry.time), "a finite number");
        if (i == 0 || entry.time > entries[i - 1].time) continue;
        const SeriesEntry& before = entries[i - 1];
        if (entry.time == before.time && entry.part > before.part) continue;
        if (entry.time == before.time)
            throw InputError(path,
                             fmt::format("'{}' and '{}' have the same time {}", before.file, entry.file, entry.time),
                             "one file for each time and each part");
        throw InputError(path,
                         fmt::format("'{}' at time {} comes after '{}' at time {}", entry.file, entry.time, before.file,
                                     before.time),
                         "times that increase");
    }
}

/// A collection's entries by time. Files of one time are parts of one data set, also where none of them has a number;
/// they are parts in their order then. Some programs write one part at all times, then the next.
std::vector<SeriesEntry> numberedParts(std::vector<SeriesEntry> entries)
{
    std::map<double, int> known, numbered;  // How many there are of a time.
    for (const SeriesEntry& entry : entries) {
        ++known[entry.time];
        numbered[entry.time] += entry.part != 0;
    }
    bool areParts = false;
    std::map<double, int> next;
    for (SeriesEntry& entry : entries) {
        areParts = areParts || known[entry.time] > 1 || entry.part != 0;
        if (numbered[entry.time] == 0) entry.part = next[entry.time]++;
    }
    if (areParts)
        std::ranges::stable_sort(entries, [](const SeriesEntry& a, const SeriesEntry& b) {
            return a.time < b.time || (a.time == b.time && a.part < b.part);
        });
    return entries;
}

void checkFiles(const std::string& path, const TimeSeries& series)
{
    const std::string kind = lowerExtension(series.steps.front().path);
    for (const StepFile& step : series.steps)
        for (const std::string& file : step.files()) {
            const std::string extension = lowerExtension(file);
            if (extension != kind)
                throw InputError(path, fmt::format("'{}' and '{}' differ in kind", series.steps.front().path, file),
                                 "files that end alike");
            if (isList(file)) throw InputError(path, fmt::format("'{}' is a series itself", file), "data files");
            const FileKind* named = fileKindOf(file);
            const FilePieces pieces = named ? named->pieces : FilePieces::none;
            if (!step.others.empty() && (pieces == FilePieces::whole || pieces == FilePieces::apart))
                throw InputError(path, fmt::format("its part '{}' lies in pieces itself", file),
                                 "parts that are single files");
            std::error_code error;
            if (!fs::exists(file, error))
                throw InputError(path, fmt::format("its step '{}' is not there", file), "a file for each step");
        }
}

}  // namespace

Around bracketOf(const std::vector<double>& times, double moment)
{
    const auto step = [](std::size_t number) { return Around{double(number), double(number), 0}; };
    if (!(moment > times.front())) return step(0);
    if (moment >= times.back()) return step(times.size() - 1);
    const auto after = std::size_t(std::upper_bound(times.begin(), times.end(), moment) - times.begin());
    const double lo = times[after - 1], hi = times[after];
    // Halved first: the distance of two huge times of either sign must not overflow.
    const double weight = (0.5 * moment - 0.5 * lo) / (0.5 * hi - 0.5 * lo);
    if (!(weight > 0)) return step(after - 1);
    return weight < 1 ? Around{double(after - 1), double(after), weight} : step(after);
}

bool namesSeries(const std::string& path)
{
    return !namedKindHas(path, kIsFolder) && (isList(path) || isNumberPattern(path));
}

TimeSeries readTimeSeries(const std::string& path)
{
    std::vector<SeriesEntry> entries;
    if (isList(path)) {
        entries = listedFiles(path);
        if (entries.empty()) throw InputError(path, "it names no files", "at least one");
        const fs::path folder = fs::path(path).parent_path();
        for (SeriesEntry& entry : entries) entry.file = (folder / entry.file).string();
    } else {
        entries = numberedFiles(path);
    }
    if (lowerExtension(path) == ".pvd") entries = numberedParts(std::move(entries));
    checkTimes(path, entries);
    TimeSeries series;
    for (SeriesEntry& entry : entries) {
        if (!series.times.empty() && entry.time == series.times.back()) {
            series.steps.back().others.push_back(std::move(entry.file));
            continue;
        }
        series.times.push_back(entry.time);
        series.steps.push_back({std::move(entry.file), std::nullopt});
    }
    checkFiles(path, series);
    return series;
}

TimeSeries seriesInFile(const std::string& path, const std::vector<double>& timeSteps)
{
    std::vector<SeriesEntry> entries;
    entries.reserve(timeSteps.size());
    for (const double time : timeSteps) entries.push_back({fmt::format("{}, time {}", path, time), time});
    checkTimes(path, entries);
    TimeSeries series{timeSteps, {}};
    for (const double time : timeSteps) series.steps.push_back({path, time});
    return series;
}

std::string firstFileOf(const std::string& spec)
{
    return namesSeries(spec) ? readTimeSeries(spec).steps.front().path : spec;
}

std::vector<double> mergedTimes(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> merged;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(merged));
    return merged;
}

double startOf(const SceneDescription& description, const std::vector<double>& times)
{
    if (description.time.moment) return *description.time.moment;
    if (description.time.range) return (*description.time.range)[0];
    if (times.empty()) return 0;
    return description.time.momentOf == MomentOf::last ? times.back() : times.front();
}

double momentOfFrame(const std::array<double, 2>& range, int index, int frames)
{
    if (index <= 0 || frames <= 1) return range[0];
    if (index >= frames - 1) return range[1];
    return range[0] + (range[1] - range[0]) * index / (frames - 1);
}

}  // namespace aeolic
