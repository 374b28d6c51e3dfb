#include "data/load/file_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "aeolic/error.h"
#include "base/number_near.h"
#include "data/load/proposed_commands.h"
#include "data/load/series/time_series.h"
#include "data/reading/file_questions.h"
#include "data/reading/reader_pool.h"
#include "description/builtin_names.h"

namespace aeolic {

namespace {

/// 1234567 -> "1,234,567".
std::string grouped(std::int64_t count)
{
    std::string digits = std::to_string(count);
    for (auto i = std::ptrdiff_t(digits.size()) - 3; i > 0; i -= 3) digits.insert(std::size_t(i), 1, ',');
    return digits;
}

std::string bytesText(std::uintmax_t bytes)
{
    const char* units[] = {"bytes", "kB", "MB", "GB", "TB"};
    double value = double(bytes);
    std::size_t unit = 0;
    for (; value >= 1000 && unit < 4; ++unit) value /= 1000;
    return fmt::format("{:.3g} {}", value, units[unit]);
}

using Row = std::vector<std::string>;

/// Columns as wide as their widest entry, two spaces apart; columns of numbers to the right.
std::string table(const std::vector<Row>& rows, const std::vector<bool>& right)
{
    std::vector<std::size_t> width(right.size(), 0);
    for (const Row& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
    std::string text;
    for (const Row& row : rows) {
        std::string line = " ";
        for (std::size_t c = 0; c < row.size(); ++c)
            line += right[c] ? fmt::format(" {:>{}} ", row[c], width[c]) : fmt::format(" {:<{}} ", row[c], width[c]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

/// A series' number of files and their size together, or one file's size.
std::string sizeText(const std::string& path, const std::optional<TimeSeries>& series)
{
    std::error_code ignored;
    if (!series) return bytesText(std::filesystem::file_size(path, ignored));
    std::uintmax_t bytes = 0;
    std::size_t count = 0;
    for (const StepFile& step : series->steps)
        for (const std::string& file : step.files()) {
            bytes += std::filesystem::file_size(file, ignored);
            ++count;
        }
    return fmt::format("{} in {}", bytesText(bytes), count == 1 ? "1 file" : fmt::format("{} files", count));
}

std::string headLines(const std::string& path, const FileSummary& summary, const std::optional<TimeSeries>& series)
{
    std::string text = fmt::format("{}: {}{}{}\n\n", path, series ? "a series of " : "", summary.kind,
                                   summary.namesFiles ? "" : ", " + sizeText(path, series));
    const auto line = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<12}{}\n", what, value);
    };
    if (summary.blocks > 0) line("blocks", grouped(summary.blocks));
    if (summary.dims)
        line("dimensions", fmt::format("{} x {} x {}", (*summary.dims)[0], (*summary.dims)[1], (*summary.dims)[2]));
    line("points", grouped(summary.points) + (summary.isOfFaces ? " on patches" : ""));
    line(summary.isOfFaces ? "faces" : "cells", grouped(summary.cells) + (summary.isOfFaces ? " on patches" : ""));
    if (const auto& steps = summary.timeSteps; steps.size() == 1) line("time", timeText(steps[0], steps));
    if (const auto& steps = summary.timeSteps; steps.size() > 1)
        line("time steps", fmt::format("{}, from {} to {}", steps.size(), timeText(steps.front(), steps),
                                       timeText(steps.back(), steps)));
    return text;
}

/// What --surface can name behind ':'. The type is a group as well.
std::string partLines(const FileSummary& summary)
{
    if (summary.parts.empty()) return "";
    const bool cells = std::ranges::any_of(summary.parts, [](const PartSummary& part) { return part.fillsSpace; });
    std::vector<Row> rows{{"part", "type", cells ? "cells" : "faces", "groups"}};
    for (const PartSummary& part : summary.parts)
        rows.push_back({part.name, part.type, grouped(part.polygons), fmt::format("{}", fmt::join(part.groups, ", "))});
    return "\n" + table(rows, {false, false, true, false});
}

/// Times and files: all of a few, else the first and the last.
std::string stepLines(const TimeSeries& series)
{
    constexpr std::size_t shownAtEnds = 4;
    const std::size_t count = series.steps.size();
    std::vector<Row> rows{{"step", "time", "file"}};
    for (std::size_t i = 0; i < count; ++i) {
        if (i >= shownAtEnds && i + shownAtEnds < count && count > 2 * shownAtEnds + 1) {
            if (i == shownAtEnds) rows.push_back({"…", "", ""});
            continue;
        }
        const StepFile& step = series.steps[i];
        const std::string more = step.others.empty() ? "" : fmt::format(" and {} more", step.others.size());
        rows.push_back({std::to_string(i), timeText(series.times[i], series.times), step.path + more});
    }
    const bool apart = !series.steps.front().others.empty();
    const char* below = count > 1 ? (apart ? "\nThe first file of the first step:\n" : "\nThe first step:\n")
                                  : (apart ? "\nThe first file:\n" : "");
    return "\n" + table(rows, {true, true, false}) + below;
}

std::string boundsLines(const FileSummary& summary)
{
    const Bounds& b = summary.boundsWorld;
    if (b.empty()) return "";
    std::vector<Row> rows{{"", "from", "to", "size", summary.spacingWorld ? "spacing" : ""}};
    const double tiny = 1e-12 * b.diagonal();  // What rounding leaves of a zero.
    const auto number = [&](double value) { return fmt::format("{:.6g}", std::abs(value) < tiny ? 0.0 : value); };
    for (int c = 0; c < 3; ++c) {
        const double size = b.hi[c] - b.lo[c] > tiny ? b.hi[c] - b.lo[c] : b.diagonal();
        const auto place = [&](double value) { return std::abs(value) < tiny ? "0" : numberNear(value, size, 6); };
        rows.push_back({std::string(1, "xyz"[c]), place(b.lo[c]), place(b.hi[c]), number(b.hi[c] - b.lo[c]),
                        summary.spacingWorld ? number((*summary.spacingWorld)[std::size_t(c)]) : ""});
    }
    return "\n" + table(rows, {false, true, true, true, true});
}

/// All of a few, else how many.
std::string timesText(const std::vector<double>& times)
{
    constexpr std::size_t kShown = 6;
    if (times.size() > kShown)
        return fmt::format("{} times, from {:.6g} to {:.6g}", times.size(), times.front(), times.back());
    std::string text = times.size() == 1 ? "time" : "times";
    for (std::size_t i = 0; i < times.size(); ++i) text += fmt::format("{}{:.6g}", i == 0 ? " " : ", ", times[i]);
    return text;
}

std::string arrayLines(const FileSummary& summary)
{
    if (summary.arrays.empty()) return "\n  no arrays\n";
    std::vector<Row> rows{{"array", "on", "type", "components", "min", "max", "masked"}};
    for (const ArraySummary& a : summary.arrays) {
        const std::string mark = a.components > 1 ? " (length)" : "";
        rows.push_back({a.name, a.association, a.type, std::to_string(a.components),
                        a.range ? fmt::format("{:.6g}", (*a.range)[0]) : "-",
                        a.range ? fmt::format("{:.6g}{}", (*a.range)[1], mark) : "-",
                        a.masked + a.nonFinite > 0 ? grouped(a.masked + a.nonFinite) : "-"});
    }
    std::string text = "\n" + table(rows, {false, false, false, true, true, false, true});
    for (const ArraySummary& a : summary.arrays)
        if (!a.times.empty()) text += fmt::format("  {}: only at {}\n", a.name, timesText(a.times));
    return text;
}

/// What is known of a file, and the lines about it that stand in front of those about commands.
FileInfo withSuggestions(const std::string& path, FileSummary summary, std::string text)
{
    const ProposedCommands found = proposedCommands(path, summary);
    FileInfo info{std::move(summary), {}, std::move(text)};
    info.text += found.none.empty() ? "\nTry:\n" : "\nNothing to draw: " + found.none + ".\n";
    for (const std::string& command : found.commands) {
        info.suggestions.push_back("aeolic render " + command + " -o out.png");
        info.text += "  " + info.suggestions.back() + "\n";
    }
    if (!found.note.empty()) info.text += found.note + "\n";
    return info;
}

/// What is drawn without a file is no misspelt file.
void refuseBuiltin(const std::string& path)
{
    const bool surface = isBuiltinSurface(path), flow = isBuiltinFlow(path);
    if ((!surface && !flow) || std::filesystem::exists(path)) return;
    throw InputError(path, surface ? "a built-in surface" : "a built-in flow",
                     fmt::format("a file; 'aeolic render {}{}' draws it", surface ? "" : "--surface torus --field ",
                                 surface ? fmt::format("--surface {} --field abc", path) : path));
}

}  // namespace

FileInfo fileInfo(const std::string& path)
{
    refuseBuiltin(path);
    const KeptReaders readers;
    std::optional<TimeSeries> series;
    if (namesSeries(path)) series = readTimeSeries(path);
    FileSummary summary = summarizeFile(series ? series->steps.front().path : path);
    if (series) summary.timeSteps = series->times;
    std::string text = headLines(path, summary, series) + (series ? stepLines(*series) : partLines(summary)) +
                       boundsLines(summary) + arrayLines(summary);
    return withSuggestions(path, std::move(summary), std::move(text));
}

std::string describeFile(const std::string& path)
{
    return fileInfo(path).text;
}

}  // namespace aeolic
