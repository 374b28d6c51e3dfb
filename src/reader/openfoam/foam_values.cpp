#include <fmt/format.h>
#include <regex.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "aeolic/error.h"
#include "reader/openfoam/foam_mesh.h"
#include "reader/openfoam/foam_stream.h"

namespace aeolic {
namespace {

constexpr std::size_t kLongestPattern = 200;

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
    if (pattern.size() > kLongestPattern || pattern.find('{') != std::string::npos) return false;
    regex_t compiled;
    if (regcomp(&compiled, ("^(" + pattern + ")$").c_str(), REG_EXTENDED | REG_NOSUB) != 0) return false;
    const bool found = regexec(&compiled, name.c_str(), 0, nullptr, 0) == 0;
    regfree(&compiled);
    return found;
}

bool names(const Entry& entry, const FoamPatch& patch)
{
    if (entry.pattern) return fits(entry.key, patch.name);
    return entry.key == patch.name ||
           std::find(patch.groups.begin(), patch.groups.end(), entry.key) != patch.groups.end();
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

void append(std::vector<float>& values, const double* value, int components)
{
    for (int c = 0; c < components; ++c) values.push_back(float(value[c]));
}

/// "uniform (0 0 0)": the value behind the word.
std::vector<float> readUniform(FoamStream& in, int components, const std::string& item)
{
    std::vector<float> value;
    if (components > 1) in.expect("(", item);
    for (int c = 0; c < components; ++c) value.push_back(float(in.scalar(item)));
    if (components > 1) in.expect(")", item);
    return value;
}

/// Passes over List<vector>; a list of no values may have no type.
void readListType(FoamStream& in, int components, const std::string& item)
{
    if (!in.peekToken().starts_with("List<")) return;
    const std::string type = in.token();
    if (foamComponents(std::string_view(type).substr(5, type.size() - 6)) != components)
        in.fail(fmt::format("{}: found {}", item, type), components == 1 ? "List<scalar>" : "List<vector>");
}

void readValue(FoamStream& in, int components, const std::string& item, Entry& entry)
{
    const std::string word = in.token();
    entry.hasValue = true;
    if (word == "uniform") {
        entry.uniform = true;
        entry.values = readUniform(in, components, item);
    } else if (word == "nonuniform") {
        readListType(in, components, item);
        in.values(components, item,
                  [&](std::uint64_t, const double* value) { append(entry.values, value, components); });
    } else if (word == "$internalField") {
        entry.hasValue = false;
        entry.internal = true;
    } else {
        in.fail(fmt::format("{}: found '{}'", item, word.substr(0, 40)), "uniform or nonuniform");
    }
    in.expect(";", item);
}

Entry readEntry(FoamStream& in, int components, const std::vector<FoamPatch>& patches)
{
    Entry entry;
    entry.key = in.token();
    entry.pattern = in.quoted();
    const std::string item = fmt::format("boundaryField, '{}'", entry.key);
    entry.kept = std::any_of(patches.begin(), patches.end(), [&](const FoamPatch& p) { return names(entry, p); });
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

/// Goes to the entry `name` of the field; false where there is none.
bool goTo(FoamStream& in, const std::string& name)
{
    for (std::string key = in.token(); !key.empty(); key = in.token()) {
        if (key == name) return true;
        in.skipEntry(key);
    }
    return false;
}

std::vector<Entry> readBoundaryField(const std::string& path, int components, const std::vector<FoamPatch>& patches)
{
    FoamStream in(path);
    if (!goTo(in, "boundaryField")) in.fail("it has no boundaryField", "the field's values on patches");
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

/// The values of single cells, by their numbers.
std::map<std::int64_t, std::vector<float>> readCells(const std::string& path, int components,
                                                     const std::vector<std::int64_t>& owners)
{
    std::map<std::int64_t, std::vector<float>> cells;
    for (const std::int64_t owner : owners) cells[owner];
    const std::string item = "internalField";
    FoamStream in(path);
    if (!goTo(in, item)) in.fail("it has no internalField", "the field's values in cells");
    const std::string word = in.token();
    if (word == "uniform") {
        const std::vector<float> value = readUniform(in, components, item);
        for (auto& [number, cell] : cells) cell = value;
        return cells;
    }
    if (word != "nonuniform") in.fail(fmt::format("{}: found '{}'", item, word), "uniform or nonuniform");
    readListType(in, components, item);
    auto next = cells.begin();
    const std::uint64_t found = in.values(components, item, [&](std::uint64_t i, const double* value) {
        if (next == cells.end() || next->first != std::int64_t(i)) return;
        append(next->second, value, components);
        ++next;
    });
    if (next != cells.end())
        in.fail(fmt::format("{}: {} values, none for cell {}", item, found, next->first), "one for each cell");
    return cells;
}

bool isMirror(const std::string& type)
{
    return type == "slip" || type == "wedge" || type.starts_with("symmetry") || type == "basicSymmetry";
}

/// Fills what boundaryField leaves open. `open`: which faces, in order.
void takeCells(const std::string& path, const std::string& ownerPath, int components, const FoamFaces& faces,
               const std::vector<std::pair<std::size_t, bool>>& open, std::vector<float>& values)
{
    std::vector<std::uint64_t> numbers;
    for (const auto& [face, mirror] : open) numbers.push_back(faces.numbers[face]);
    const std::vector<std::int64_t> owners = readFoamLabels(ownerPath, numbers);
    const auto cells = readCells(path, components, owners);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto [face, mirror] = open[i];
        const std::vector<float>& cell = cells.at(owners[i]);
        float* value = &values[face * std::size_t(components)];
        std::copy(cell.begin(), cell.end(), value);
        if (!mirror || components != 3) continue;
        const glm::dvec3 normal = faces.normal(face), v(value[0], value[1], value[2]);
        const glm::dvec3 along = v - glm::dot(v, normal) * normal;
        for (int c = 0; c < 3; ++c) value[c] = float(along[c]);
    }
}

}  // namespace

std::vector<float> readFoamValues(const FoamCase& foam, const std::string& folder, const std::string& region,
                                  double time, const FoamField& field, const std::vector<FoamPatch>& patches,
                                  const FoamFaces& faces)
{
    const std::string path = (std::filesystem::path(foamTimeFolder(folder, time)) / region / field.name).string();
    if (foamFileOf(path).empty())
        throw InputError(foam.name, fmt::format("there is no {}", path), fmt::format("the field '{}'", field.name));
    const auto width = std::size_t(field.components);
    const std::vector<Entry> entries = readBoundaryField(path, field.components, patches);
    std::vector<float> values(faces.count() * width, 0.0f);
    std::vector<std::pair<std::size_t, bool>> open;
    std::size_t face = 0;
    for (const FoamPatch& patch : patches) {
        if (patch.faces == 0) continue;
        const Entry* entry = entryFor(entries, patch);
        if (!entry)
            throw InputError(foamFileOf(path), fmt::format("boundaryField has no entry for patch '{}'", patch.name),
                             "one for each patch");
        if (entry->hasValue && !entry->uniform && entry->values.size() != patch.faces * width)
            throw InputError(foamFileOf(path),
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
        takeCells(path, foamMeshFile(folder, region, time, "owner"), field.components, faces, open, values);
    return values;
}

}  // namespace aeolic
