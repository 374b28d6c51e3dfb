#include "data/load/file_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "aeolic/error.h"
#include "data/load/series/time_series.h"
#include "data/named_file.h"
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

/// A name the shell takes for one word.
std::string shellWord(const std::string& text)
{
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string("._-/+:,=@").find(c) != std::string::npos;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
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
std::string sizeText(const std::string& path, const TimeSeries* series)
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

std::string headLines(const std::string& path, const FileSummary& summary, const TimeSeries* series)
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
    if (const auto& steps = summary.timeSteps; steps.size() == 1) line("time", fmt::format("{:.6g}", steps[0]));
    if (const auto& steps = summary.timeSteps; steps.size() > 1)
        line("time steps", fmt::format("{}, from {:.6g} to {:.6g}", steps.size(), steps.front(), steps.back()));
    return text;
}

/// What --surface can name behind ':'. The type is a group as well.
std::string partLines(const FileSummary& summary)
{
    if (summary.parts.empty()) return "";
    const bool cells = std::any_of(summary.parts.begin(), summary.parts.end(),
                                   [](const PartSummary& part) { return part.fillsSpace; });
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
        rows.push_back({std::to_string(i), fmt::format("{:.6g}", series.times[i]), step.path + more});
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
    for (int c = 0; c < 3; ++c)
        rows.push_back({std::string(1, "xyz"[c]), number(b.lo[c]), number(b.hi[c]), number(b.hi[c] - b.lo[c]),
                        summary.spacingWorld ? number((*summary.spacingWorld)[std::size_t(c)]) : ""});
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

/// Commands draw the first time, unless they name another.
bool isAtFirstTime(const ArraySummary& array, const FileSummary& summary)
{
    return array.times.empty() || array.times.front() == summary.timeSteps.front();
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

int shortestSide(const Bounds& b)
{
    const glm::dvec3 size = b.hi - b.lo;
    return size.z <= size.x && size.z <= size.y ? 2 : size.y <= size.x ? 1 : 0;
}

/// Looks at a plane across that axis from where the default view sees its front.
std::string straightView(int axis)
{
    return fmt::format(" --camera azimuth={},elevation={}", axis == 0 ? 90 : 0, axis == 2 ? 90 : 0);
}

/// A volume of one layer of cells, or not much thicker: its outside is mostly edge.
bool isThin(const Bounds& b)
{
    constexpr double most = 0.101;  // Times the next longer side; a tenth but for rounding.
    const glm::dvec3 size = b.hi - b.lo;
    const int axis = shortestSide(b);
    return size[axis] < most * std::min(size[(axis + 1) % 3], size[(axis + 2) % 3]);
}

/// The plane through the middle across the shortest side: the largest slice. `sideAcross`: that of a case in two
/// dimensions, whatever its thickness.
std::string middleSlice(const Bounds& b, std::optional<int> sideAcross = {})
{
    const glm::dvec3 c = b.center();
    const int axis = sideAcross.value_or(shortestSide(b));
    return fmt::format("slice:{:.4g},{:.4g},{:.4g}:{},{},{}{}", c.x, c.y, c.z, int(axis == 0), int(axis == 1),
                       int(axis == 2), sideAcross || isThin(b) ? straightView(axis) : "");
}

/// A field whose cells are a surface themselves: a slice of it is a line.
std::string ownSurface(const FileSummary& summary)
{
    const auto& dims = summary.dims;
    return summary.spacingWorld && dims && std::count(dims->begin(), dims->end(), 1) == 1 ? "image" : "boundary";
}

/// Walls are drawn where no part is named; a case may have none. The first command is the one to try at other times.
std::vector<std::string> caseCommands(const std::string& path, const FileSummary& summary, const std::string& vectors,
                                      const std::string& scalar)
{
    const std::string flow = vectors.empty() ? " --field abc" : vectors + scalar;
    const bool hasU = std::any_of(summary.arrays.begin(), summary.arrays.end(),
                                  [&](const ArraySummary& a) { return a.name == "U" && isAtFirstTime(a, summary); });
    const bool beside = vectors == " --vectors U";  // On walls it is zero, so that of the cells beside them.
    const auto isWall = [](const PartSummary& part) { return part.type == "wall"; };
    // The sides of a case in two dimensions, or around an axis: all of its flow, while its walls are seen from the
    // edge.
    const auto side = std::find_if(summary.parts.begin(), summary.parts.end(),
                                   [](const PartSummary& part) { return part.sideAcross.has_value(); });
    const bool hasSide = side != summary.parts.end();
    std::vector<std::string> commands;
    if (hasU && hasSide)
        commands.push_back("--surface " + shellWord(path + ":" + side->name) + " --vectors U" + scalar +
                           straightView(*side->sideAcross));
    if (std::any_of(summary.parts.begin(), summary.parts.end(), isWall))
        commands.push_back("--surface " + shellWord(path) + (beside ? " --field " + shellWord(path) : "") + flow);
    for (const PartSummary& part : summary.parts)
        if (part.polygons > 0 && !isWall(part) && !(hasU && part.isSide()) && commands.size() < 2)
            commands.push_back("--surface " + shellWord(path + ":" + part.name) +
                               (hasU ? " --vectors U" + scalar : flow));
    if (hasU)
        commands.push_back("--field " + shellWord(path) + " --vectors U --surface " +
                           middleSlice(summary.boundsWorld, hasSide ? side->sideAcross : std::nullopt));
    return commands;
}

/// How the parts of a file can be drawn: the usual ones, one by its name, and the volume.
std::vector<std::string> partCommands(const std::string& path, const FileSummary& summary, const std::string& vectors,
                                      const std::string& scalar)
{
    std::vector<std::string> commands;
    const std::string file = shellWord(path);
    const auto named = [&](const PartSummary& part) {
        std::string name = part.name;
        std::replace(name.begin(), name.end(), ',', '*');  // Which would begin another name.
        return shellWord(path + ":" + name);
    };
    const auto isFaces = [](const PartSummary& part) { return !part.fillsSpace && part.polygons > 0; };
    const auto first = std::find_if(summary.parts.begin(), summary.parts.end(),
                                    [&](const PartSummary& part) { return isFaces(part) && part.usual; });
    const bool sliced = summary.dimension == 3, thin = summary.isVolume && sliced && isThin(summary.boundsWorld);
    const std::string slice = "--field " + file + vectors + " --surface " + middleSlice(summary.boundsWorld);
    if (thin) commands.push_back(slice);
    if (first != summary.parts.end()) {
        // On walls the flow is zero, so that of the cells beside them.
        commands.push_back("--surface " + file + (summary.isVolume ? " --field " + file : "") + vectors + scalar);
        commands.push_back("--surface " + named(*first) + vectors);
    }
    if (summary.isVolume) {
        if (sliced && !thin) commands.push_back(slice);
        if (first == summary.parts.end())
            commands.push_back("--field " + file + vectors + " --surface boundary" + scalar);
    }
    return commands;
}

/// Commands to try first, or why there are none.
struct Suggestions {
    std::vector<std::string> commands = {};  ///< What follows "aeolic render".
    std::string none = {};
};

Suggestions suggest(const std::string& path, const FileSummary& summary)
{
    const std::string file = shellWord(path);
    const std::string name = summary.vectors ? *summary.vectors : summary.firstVectors;
    std::string scalar;
    for (const ArraySummary& a : summary.arrays)
        if (scalar.empty() && a.components == 1 && a.range && isAtFirstTime(a, summary))
            scalar = " --color-by " + shellWord(a.name);
    if (scalar.empty() && !name.empty()) scalar = " --color-by " + shellWord(name + ":mag");
    const std::string vectors = name.empty() ? "" : " --vectors " + shellWord(name);

    std::vector<std::string> commands;
    if (summary.isOfFaces) {
        commands = caseCommands(path, summary, vectors, scalar);
        if (commands.empty()) return {{}, "no patch has a face"};
    } else if (summary.dimension < 2) {
        return {{}, "no cell has an area"};
    } else if (!summary.parts.empty() && !name.empty()) {
        commands = partCommands(path, summary, vectors, scalar);
    } else if (summary.isSurface && name.empty()) {
        commands.push_back("--surface " + file + " --field abc");
        commands.push_back("--surface " + file + " --field FIELD.vti");
    } else if (summary.isSurface) {
        commands.push_back("--surface " + file + vectors);
        commands.push_back("--surface " + file + vectors + scalar);
    } else if (name.empty() || summary.boundsWorld.empty()) {
        return {{}, "no array of three components"};
    } else if (summary.dimension == 2) {
        commands.push_back("--field " + file + vectors + " --surface " + ownSurface(summary) + scalar);
    } else {
        commands.push_back("--field " + file + vectors + " --surface " + middleSlice(summary.boundsWorld));
        commands.push_back("--field " + file + vectors + " --surface boundary" + scalar);
    }
    if (const auto& steps = summary.timeSteps; steps.size() > 1) {
        const std::string command = summary.parts.empty() ? commands.back() : commands.front();
        commands.push_back(command + fmt::format(" --time {:.6g}", steps[steps.size() / 2]));
        commands.push_back(command + fmt::format(" --frames {} --time-range {:.6g},{:.6g}", steps.size(), steps.front(),
                                                 steps.back()));
    }
    return {commands};
}

/// What is known of a file, and the lines about it that stand in front of those about commands.
FileInfo withSuggestions(const std::string& path, FileSummary summary, std::string text)
{
    const Suggestions found = suggest(path, summary);
    FileInfo info{std::move(summary), {}, std::move(text)};
    info.text += found.none.empty() ? "\nTry:\n" : "\nNothing to draw: " + found.none + ".\n";
    for (const std::string& command : found.commands) {
        info.suggestions.push_back("aeolic render " + command + " -o out.png");
        info.text += "  " + info.suggestions.back() + "\n";
    }
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
    if (!namesSeries(path)) {
        FileSummary summary = summarizeFile(path);
        std::string text =
            headLines(path, summary, nullptr) + partLines(summary) + boundsLines(summary) + arrayLines(summary);
        return withSuggestions(path, std::move(summary), std::move(text));
    }
    const TimeSeries series = readTimeSeries(path);
    FileSummary summary = summarizeFile(series.steps.front().path);
    summary.timeSteps = series.times;
    std::string text =
        headLines(path, summary, &series) + stepLines(series) + boundsLines(summary) + arrayLines(summary);
    return withSuggestions(path, std::move(summary), std::move(text));
}

std::string describeFile(const std::string& path)
{
    return fileInfo(path).text;
}

}  // namespace aeolic
