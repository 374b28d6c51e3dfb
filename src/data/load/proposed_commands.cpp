#include "data/load/proposed_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "base/number_near.h"
#include "base/text.h"
#include "data/named_file.h"
#include "data/vector_names.h"

namespace aeolic {
namespace {

/// A name the shell takes for one word.
std::string shellWord(const std::string& text)
{
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string("._-/+:,=@").find(c) != std::string::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

/// Commands draw the first time, unless they name another.
bool isAtFirstTime(const ArraySummary& array, const FileSummary& summary)
{
    return array.times.empty() || array.times.front() == summary.timeSteps.front();
}

int shortestSide(const Bounds& b)
{
    const glm::dvec3 size = b.hi - b.lo;
    return size.z <= size.x && size.z <= size.y ? 2 : size.y <= size.x ? 1 : 0;
}

bool meets(const Bounds& a, const Bounds& b)
{
    return !a.empty() && !b.empty() && glm::all(glm::lessThanEqual(a.lo, b.hi)) &&
           glm::all(glm::greaterThanEqual(a.hi, b.lo));
}

/// Looks at a plane across that axis from where the default view sees its front.
std::string straightView(int axis)
{
    return fmt::format(" --camera azimuth={},elevation={}", axis == 0 ? 90 : 0, axis == 2 ? 90 : 0);
}

/// Looks straight at data that are flat in an axis; else empty.
std::string straightIfFlat(const Bounds& b)
{
    const int axis = shortestSide(b);
    return b.hi[axis] - b.lo[axis] <= 1e-9 * b.diagonal() ? straightView(axis) : "";
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
    std::string place;
    for (int k = 0; k < 3; ++k) place += (k > 0 ? "," : "") + numberNear(c[k], b.hi[k] - b.lo[k], 4);
    return fmt::format("slice:{}:{},{},{}{}", place, int(axis == 0), int(axis == 1), int(axis == 2),
                       sideAcross || isThin(b) ? straightView(axis) : "");
}

/// A field whose cells are a surface themselves: a slice of it is a line.
std::string ownSurface(const FileSummary& summary)
{
    const auto& dims = summary.dims;
    return summary.spacingWorld && dims && std::ranges::count(*dims, 1) == 1 ? "image" : "boundary";
}

/// Walls are drawn where no part is named; a case may have none. The first command is the one to try at other times.
std::vector<std::string> caseCommands(const std::string& path, const FileSummary& summary, const std::string& vectors,
                                      const std::string& scalar)
{
    const std::string flow = vectors.empty() ? " --field abc" : vectors + scalar;
    const bool hasU = std::ranges::any_of(
        summary.arrays, [&](const ArraySummary& a) { return a.name == "U" && isAtFirstTime(a, summary); });
    // The cells of regions are not read.
    const bool hasCells = std::ranges::any_of(
        summary.parts, [](const PartSummary& part) { return part.name.find('/') == std::string::npos; });
    const bool beside =
        vectors == " --vectors U" && hasCells;  // On walls it is zero, so that of the cells beside them.
    const auto isWall = [](const PartSummary& part) { return part.type == "wall"; };
    // The sides of a case in two dimensions, or around an axis: all of its flow, while its walls are seen from the
    // edge.
    const auto side =
        std::ranges::find_if(summary.parts, [](const PartSummary& part) { return part.sideAcross.has_value(); });
    const bool hasSide = side != summary.parts.end();
    std::vector<std::string> commands;
    if (hasU && hasSide)
        commands.push_back("--surface " + shellWord(path + ":" + side->name) + " --vectors U" + scalar +
                           straightView(*side->sideAcross));
    if (std::ranges::any_of(summary.parts, isWall))
        commands.push_back("--surface " + shellWord(path) + (beside ? " --field " + shellWord(path) : "") + flow);
    for (const PartSummary& part : summary.parts)
        if (part.polygons > 0 && !isWall(part) && !(hasU && part.isSide()) && commands.size() < 2)
            commands.push_back("--surface " + shellWord(path + ":" + part.name) +
                               (hasU ? " --vectors U" + scalar : flow));
    if (hasU && hasCells)
        commands.push_back("--field " + shellWord(path) + " --vectors U --surface " +
                           middleSlice(summary.boundsWorld, hasSide ? side->sideAcross : std::nullopt));
    return commands;
}

/// How the parts of a file can be drawn: the usual ones, one by its name, and the volume.
std::vector<std::string> partCommands(const std::string& path, const FileSummary& summary, const std::string& name,
                                      const std::string& scalar)
{
    std::vector<std::string> commands;
    const std::string file = shellWord(path), vectors = " --vectors " + shellWord(name);
    const auto isUsualFaces = [](const PartSummary& part) {
        return !part.fillsSpace && part.polygons > 0 && part.usual;
    };
    const auto has = [&](const PartSummary& part) {
        return std::ranges::find(part.vectors, name) != part.vectors.end();
    };
    const auto firstWhere = [&](const auto& holds) {
        const auto at = std::ranges::find_if(summary.parts, holds);
        return at == summary.parts.end() ? nullptr : &*at;
    };
    Bounds volume;
    for (const PartSummary& part : summary.parts)
        if (part.fillsSpace) volume.add(part.boundsWorld);
    const PartSummary* const touching =
        firstWhere([&](const PartSummary& part) { return isUsualFaces(part) && meets(part.boundsWorld, volume); });
    const PartSummary* const own = firstWhere([&](const PartSummary& part) { return isUsualFaces(part) && has(part); });
    const bool flowFills = firstWhere([&](const PartSummary& part) { return part.fillsSpace && has(part); }) != nullptr;
    const bool sliced = summary.dimension == 3, thin = flowFills && sliced && isThin(volume);
    const std::string slice = "--field " + file + vectors + " --surface " + middleSlice(volume),
                      straight = straightIfFlat(summary.boundsWorld);
    if (thin) commands.push_back(slice);
    if (flowFills && touching)  // On walls the flow is zero, so that of the cells beside them.
        commands.push_back("--surface " + file + " --field " + file + vectors + scalar + straight);
    else if (own)
        commands.push_back("--surface " + file + vectors + scalar + straight);
    if (own) commands.push_back("--surface " + shellWord(path + ":" + own->name) + vectors + straight);
    if (flowFills && sliced && !thin) commands.push_back(slice);
    if (flowFills && !touching) commands.push_back("--field " + file + vectors + " --surface boundary" + scalar);
    return commands;
}

/// Names by which people know a flow and what to colour it by, those that say most first.
constexpr std::array<std::string_view, 8> kFlows{"u", "velocity", "vel", "v", "uvw", "wind", "flow", "momentum"};
constexpr std::array<std::string_view, 6> kColours{"p", "pressure", "cp", "p_rgh", "t", "temperature"};

/// The place of a name in such a list; behind it where it is not there.
std::size_t rankIn(std::span<const std::string_view> names, const std::string& name)
{
    return std::size_t(std::ranges::find(names, lowerCase(name)) - names.begin());
}

bool isVector(const ArraySummary& array, const FileSummary& summary)
{
    const bool flat = summary.dimension == 2 && !straightIfFlat(summary.boundsWorld).empty();
    return (array.components == 3 && array.name != "Normals") || (array.components == 2 && flat);
}

bool flows(const ArraySummary& array)
{
    return array.range && (*array.range)[1] > 0;
}

/// The default array of vectors, or, where nothing flows in it, another in which something does; the best known first.
const ArraySummary* vectorsOf(const FileSummary& summary)
{
    const ArraySummary* best = nullptr;
    const auto isBetter = [&](const ArraySummary& a, const ArraySummary& b) {
        if (flows(a) != flows(b)) return flows(a);
        const auto isDefault = [&](const ArraySummary& array) {
            return summary.vectors && array.name == *summary.vectors;
        };
        if (isDefault(a) != isDefault(b)) return isDefault(a);
        return rankIn(kFlows, a.name) < rankIn(kFlows, b.name);
    };
    for (const ArraySummary& array : summary.arrays) {
        const bool isChoice = summary.vectors == array.name || isVector(array, summary);
        if (isChoice && isAtFirstTime(array, summary) && (!best || isBetter(array, *best))) best = &array;
    }
    return best;
}

/// Scalars that are components of vectors, whose length says more.
std::set<std::string> scalarsOfVectors(const FileSummary& summary)
{
    std::vector<std::string> names;
    for (const ArraySummary& array : summary.arrays)
        if (array.components == 1) names.push_back(array.name);
    std::set<std::string> components;
    for (const NamedComponents& each : joinComponents(names, true, true))
        for (const std::size_t i : each.of)
            if (each.of.size() > 1) components.insert(names[i]);
    return components;
}

/// What shows something: a scalar that changes, the best known first, or the vectors' length.
std::string colorsOf(const FileSummary& summary, const std::string& vectors)
{
    const ArraySummary* best = nullptr;
    const std::set<std::string> components = scalarsOfVectors(summary);
    for (const ArraySummary& array : summary.arrays) {
        if (components.contains(array.name)) continue;
        if (array.components != 1 || !array.range || !((*array.range)[0] < (*array.range)[1])) continue;
        if (!isAtFirstTime(array, summary)) continue;
        if (!best || rankIn(kColours, array.name) < rankIn(kColours, best->name)) best = &array;
    }
    if (best) return " --color-by " + shellWord(best->name);
    return vectors.empty() ? "" : " --color-by " + shellWord(vectors + ":mag");
}

}  // namespace

std::string timeText(double time, const std::vector<double>& times)
{
    const std::string text = numberNear(time, times.back() - times.front(), 6);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return read < times.front() || read > times.back() ? fmt::format("{}", time) : text;
}

ProposedCommands proposedCommands(const std::string& path, const FileSummary& summary)
{
    const std::string file = shellWord(path);
    const ArraySummary* const chosen = summary.isOfFaces ? nullptr : vectorsOf(summary);
    std::string name = chosen ? chosen->name : "";
    if (summary.isOfFaces) name = summary.vectors ? *summary.vectors : summary.firstVectors;
    const auto& steps = summary.timeSteps;
    // Runs start from rest: what is known of the arrays is that of the first moment.
    const bool rests = chosen && !flows(*chosen);
    const std::string last = rests && steps.size() > 1 ? " --time last" : "";
    const std::string scalar = colorsOf(summary, name), vectors = name.empty() ? "" : " --vectors " + shellWord(name),
                      straight = summary.dimension == 2 ? straightIfFlat(summary.boundsWorld) : "";

    std::vector<std::string> commands;
    std::string note;
    if (summary.isOfFaces) {
        commands = caseCommands(path, summary, vectors, scalar);
        if (commands.empty()) return {{}, "no patch has a face"};
    } else if (summary.dimension < 2) {
        return {{}, "no cell has an area"};
    } else if (summary.isSurface && (name.empty() || (rests && last.empty()))) {
        commands.push_back("--surface " + file + " --field abc");
        note = "A field of your own goes in the place of abc.";
    } else if (rests && last.empty()) {
        return {{}, "the vectors are zero everywhere"};
    } else if (!summary.parts.empty() && !name.empty()) {
        commands = partCommands(path, summary, name, scalar);
        if (commands.empty()) return {{}, "no part has vectors that flow"};
    } else if (summary.isSurface) {
        commands.push_back("--surface " + file + vectors + straight);
        commands.push_back("--surface " + file + vectors + scalar + straight);
    } else if (name.empty() || summary.boundsWorld.empty()) {
        return {{}, "no array of three components"};
    } else if (summary.dimension == 2) {
        const std::string surface = ownSurface(summary);
        commands.push_back("--field " + file + vectors + " --surface " + surface + scalar +
                           (surface == "image" ? "" : straight));
    } else if (namedKindHas(path, kHasMaps)) {
        commands.push_back("--field " + file + vectors + " --surface " + middleSlice(summary.boundsWorld, 2) +
                           " --color-by " + shellWord(name + ":mag"));
    } else {
        commands.push_back("--field " + file + vectors + " --surface " + middleSlice(summary.boundsWorld));
        commands.push_back("--field " + file + vectors + " --surface boundary" + scalar);
    }
    std::vector<std::string> all;
    all.reserve(commands.size() + 2);
    for (const std::string& command : commands) all.push_back(command + last);
    if (steps.size() > 1) {
        const std::string& command = summary.parts.empty() ? commands.back() : commands.front();
        if (last.empty()) all.push_back(command + " --time " + timeText(steps[steps.size() / 2], steps));
        all.push_back(command + fmt::format(" --frames {} --time-range {},{}", steps.size(),
                                            timeText(steps.front(), steps), timeText(steps.back(), steps)));
    }
    return {std::move(all), "", std::move(note)};
}

}  // namespace aeolic
