#include <fmt/format.h>
#include <regex.h>

#include <algorithm>
#include <map>
#include <optional>

#include "aeolic/error.h"
#include "reader/openfoam/foam_mesh.h"
#include "reader/openfoam/foam_stream.h"

namespace aeolic {
namespace {

/// What a boundaryField says of a patch, or of all patches that a group or a pattern names.
struct Entry {
    std::string key, type;
    bool pattern = false, kept = false;
    bool hasValue = false, uniform = false, internal = false;
    std::vector<float> values;
};

/// OpenFOAM's regular expressions: POSIX, extended, for all of the name.
bool fits(const std::string& pattern, const std::string& name)
{
    regex_t compiled;
    if (regcomp(&compiled, ("^(" + pattern + ")$").c_str(), REG_EXTENDED | REG_NOSUB) != 0) return false;
    const bool found = regexec(&compiled, name.c_str(), 0, nullptr, 0) == 0;
    regfree(&compiled);
    return found;
}

bool names(const Entry& entry, const FoamPatch& patch)
{
    if (entry.pattern) return fits(entry.key, patch.name);
    return entry.key == patch.name || std::ranges::find(patch.groups, entry.key) != patch.groups.end();
}

/// The patch's own entry, else the last for one of its groups, else the last whose pattern it fits.
const Entry* entryFor(const std::vector<Entry>& entries, const FoamPatch& patch)
{
    const Entry *group = nullptr, *pattern = nullptr;
    for (const Entry& entry : entries) {
        if (!entry.pattern && entry.key == patch.name) return &entry;
        if (names(entry, patch)) (entry.pattern ? pattern : group) = &entry;
    }
    return group ? group : pattern;
}

void append(std::vector<float>& values, std::span<const double> some)
{
    for (const double value : some) values.push_back(float(value));
}

/// Passes over List<vector>; a list of no values may have no type.
void readListType(FoamStream& in, int components, const std::string& item)
{
    if (!in.peekToken().starts_with("List<")) return;
    const std::string type = in.token();
    if (foamComponents(std::string_view(type).substr(5, type.size() - 6)) != components)
        in.fail(fmt::format("{}: found {}", item, type), components == 1 ? "List<scalar>" : "List<vector>");
}

/// Reads what stands behind "uniform" or "nonuniform", which is `word`: take(index, values) gets the values of a list.
/// Returns how many there are; nothing where all are the same, which is then in `uniform`.
std::optional<std::uint64_t> readValues(FoamStream& in, const std::string& word, int components,
                                        const std::string& item, std::vector<float>& uniform,
                                        const FoamStream::TakeValues& take)
{
    if (word == "uniform") {
        uniform.clear();
        if (components > 1) in.expect("(", item);
        for (int c = 0; c < components; ++c) uniform.push_back(float(in.scalar(item)));
        if (components > 1) in.expect(")", item);
        return std::nullopt;
    }
    if (word != "nonuniform") in.fail(fmt::format("{}: found '{}'", item, word.substr(0, 40)), "uniform or nonuniform");
    readListType(in, components, item);
    return in.values(components, item, take);
}

void readValue(FoamStream& in, int components, const std::string& item, Entry& entry)
{
    const std::string word = in.token();
    entry.internal = word == "$internalField";
    entry.hasValue = !entry.internal;
    if (entry.hasValue)
        entry.uniform = !readValues(in, word, components, item, entry.values,
                                    [&](std::uint64_t, std::span<const double> some) { append(entry.values, some); });
    in.expect(";", item);
}

Entry readEntry(FoamStream& in, int components, const std::vector<FoamPatch>& patches)
{
    Entry entry;
    entry.key = in.token();
    entry.pattern = in.quoted();
    const std::string item = fmt::format("boundaryField, '{}'", entry.key);
    entry.kept = std::ranges::any_of(patches, [&](const FoamPatch& p) { return names(entry, p); });
    in.expect("{", item);
    for (std::string key = in.token(); key != "}"; key = in.token()) {
        if (key.empty()) in.fail("the file is cut off", "a complete file");
        if (key == "value" && entry.kept) {
            readValue(in, components, item + ", value", entry);
            continue;
        }
        if (key == "type") entry.type = in.peekToken();
        in.skipEntry(item);
    }
    return entry;
}

std::vector<Entry> readBoundaryField(const FoamPath& file, int components, const std::vector<FoamPatch>& patches)
{
    FoamStream in(file);
    in.goTo("boundaryField", "the field's values on patches");
    in.expect("{", "boundaryField");
    std::vector<Entry> entries;
    while (in.peekToken() != "}") {
        if (in.peekToken().empty()) in.fail("the file is cut off within boundaryField", "a complete file");
        entries.push_back(readEntry(in, components, patches));
    }
    in.token();
    in.finish();
    return entries;
}

/// Reads a field's values in cells: calls take(index, values) with those of a list, and returns how many there are.
/// Nothing is returned where all cells have the same, which is then in `uniform`.
std::optional<std::uint64_t> forEachCell(FoamStream& in, int components, std::vector<float>& uniform,
                                         const FoamStream::TakeValues& take)
{
    const std::string item = "internalField";
    in.goTo(item, "the field's values in cells");
    return readValues(in, in.token(), components, item, uniform, take);
}

/// The values of single cells, by their numbers.
std::map<std::int64_t, std::vector<float>> readSomeCells(const FoamPath& file, int components,
                                                         const std::vector<std::int64_t>& owners)
{
    std::map<std::int64_t, std::vector<float>> cells;
    for (const std::int64_t owner : owners) cells[owner];
    auto next = cells.begin();
    std::vector<float> uniform;
    FoamStream in(file);
    const auto width = std::size_t(components);
    const auto found = forEachCell(in, components, uniform, [&](std::uint64_t first, std::span<const double> some) {
        for (; next != cells.end() && std::uint64_t(next->first) < first + some.size() / width; ++next)
            append(next->second, some.subspan((std::size_t(next->first) - std::size_t(first)) * width, width));
    });
    if (!found)
        for (auto& [number, cell] : cells) cell = uniform;
    else if (next != cells.end())
        in.fail(fmt::format("internalField: {} values, none for cell {}", *found, next->first), "one for each cell");
    return cells;
}

bool isMirror(const std::string& type)
{
    return type == "slip" || type == "wedge" || type.starts_with("symmetry") || type == "basicSymmetry";
}

/// Fills what boundaryField leaves open. `open`: which faces, in order.
void takeCells(const FoamPath& file, const FoamPath& ownerFile, int components, const FoamFaces& faces,
               const std::vector<std::pair<std::size_t, bool>>& open, std::vector<float>& values)
{
    std::vector<std::uint64_t> numbers;
    numbers.reserve(open.size());
    for (const auto& [face, mirror] : open) numbers.push_back(faces.numbers[face]);
    const std::vector<std::int64_t> owners = readFoamLabels(ownerFile, numbers);
    const auto cells = readSomeCells(file, components, owners);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto [face, mirror] = open[i];
        const std::vector<float>& cell = cells.at(owners[i]);
        float* value = &values[face * std::size_t(components)];
        std::ranges::copy(cell, value);
        if (!mirror || components != 3) continue;
        const glm::dvec3 normal = faces.normal(face), v(value[0], value[1], value[2]);
        const glm::dvec3 along = v - glm::dot(v, normal) * normal;
        for (int c = 0; c < 3; ++c) value[c] = float(along[c]);
    }
}

}  // namespace

std::vector<float> readFoamValues(const FoamPath& folder, const std::string& region, double time,
                                  const FoamField& field, const std::vector<FoamPatch>& patches, const FoamFaces& faces)
{
    const FoamPath file = foamFieldFile(folder, region, time, field.name);
    const auto width = std::size_t(field.components);
    const std::vector<Entry> entries = readBoundaryField(file, field.components, patches);
    std::vector<float> values(faces.faces.count() * width, 0.0f);
    std::vector<std::pair<std::size_t, bool>> open;
    std::size_t face = 0;
    for (const FoamPatch& patch : patches) {
        if (patch.faces == 0) continue;
        const Entry* entry = entryFor(entries, patch);
        if (!entry)
            throw InputError(foamFileOf(file), fmt::format("boundaryField has no entry for patch '{}'", patch.name),
                             "one for each patch");
        if (entry->hasValue && !entry->uniform && entry->values.size() != patch.faces * width)
            throw InputError(foamFileOf(file),
                             fmt::format("patch '{}' has {} values", patch.name, entry->values.size() / width),
                             fmt::format("{}, one for each of its faces", patch.faces));
        for (std::uint64_t i = 0; i < patch.faces; ++i, ++face) {
            if (entry->hasValue)
                std::copy_n(entry->values.begin() + std::ptrdiff_t(entry->uniform ? 0 : i * width), width,
                            values.begin() + std::ptrdiff_t(face * width));
            else if (entry->type != "noSlip")
                open.emplace_back(face, !entry->internal && isMirror(entry->type));
        }
    }
    if (!open.empty())
        takeCells(file, foamMeshFile(folder, region, time, "owner"), field.components, faces, open, values);
    return values;
}

std::vector<float> readFoamCells(const FoamPath& file, const FoamField& field, std::size_t cells)
{
    std::vector<float> values, uniform;
    values.reserve(cells * std::size_t(field.components));
    FoamStream in(file);
    const auto found = forEachCell(in, field.components, uniform,
                                   [&](std::uint64_t, std::span<const double> some) { append(values, some); });
    for (std::size_t i = 0; !found && i < cells; ++i) values.insert(values.end(), uniform.begin(), uniform.end());
    if (found.value_or(cells) != cells)
        in.fail(fmt::format("internalField has {} values", *found), fmt::format("{}, one for each cell", cells));
    in.finish();
    return values;
}

}  // namespace aeolic
