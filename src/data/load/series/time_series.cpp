#include "data/load/series/time_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/load/series/series_files.h"
#include "data/named_file.h"
#include "data/reading/file_questions.h"

namespace aeolic {

namespace fs = std::filesystem;

namespace {

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
