#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "aeolic/error.h"
#include "description/color_by.h"
#include "reader/openfoam/foam_case.h"
#include "reader/openfoam/foam_parts.h"

namespace aeolic {
namespace {

/// Other files may lie beside the fields: theirs is empty.
std::string classOf(const FoamPath& file)
{
    try {
        return FoamStream(file).className();
    } catch (const InputError&) {
        return "";
    }
}

/// Notes the fields of a time's folder. The header of one that is known is not read again.
void addFields(const FoamPath& folder, double time, std::vector<FoamField>& fields)
{
    for (const std::string& entry : namesInFolder(folder.path)) {
        const std::filesystem::path file = folder.path / entry;
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error) || entry.ends_with("~") || entry.ends_with(".orig"))
            continue;
        const std::string name = file.extension() == ".gz" ? file.stem().string() : entry;
        const auto same = [&](const FoamField& field) { return field.name == name; };
        auto known = std::ranges::find_if(fields, same);
        if (known == fields.end()) {
            const std::string type = classOf(folder / name);
            if (type != "volVectorField" && type != "volScalarField") continue;
            known = fields.insert(fields.end(), {name, type == "volVectorField" ? 3 : 1});
        }
        if (known->times.empty() || known->times.back() != time) known->times.push_back(time);
    }
}

/// The fields that an array like "U", "U:mag" or "cell:U" may be of.
std::array<std::string, 2> namesOf(const std::string& array)
{
    return {array, parseArray(array).name};
}

/// The file of the field at a time, in the first region that has one.
std::optional<FoamPath> fileOf(const FoamCase& foam, double time, const std::string& array)
{
    if (array.empty() || array.find('/') != std::string::npos) return std::nullopt;
    for (const std::string& region : foam.regions)
        for (const std::string& name : namesOf(array))
            if (FoamPath file = foamFieldFile(foam.folders.front(), region, time, name); !foamFileOf(file).empty())
                return file;
    return std::nullopt;
}

const FoamField* fieldOf(const std::vector<FoamField>& fields, const std::string& array)
{
    for (const std::string& name : namesOf(array))
        for (const FoamField& field : fields)
            if (field.name == name) return &field;
    return nullptr;
}

}  // namespace

std::vector<FoamField> foamFields(const FoamCase& foam, const std::vector<double>& times)
{
    std::vector<FoamField> fields;
    for (const double time : times)
        for (const std::string& region : foam.regions)
            addFields(foamFieldFile(foam.folders.front(), region, time, ""), time, fields);
    return fields;
}

std::string usualFoamVectors(const std::vector<FoamField>& fields, bool walls)
{
    std::vector<std::string> vectors;
    for (const FoamField& field : fields)
        if (field.components == 3) vectors.push_back(field.name);
    for (const char* const name : {"wallShearStress", "U"})
        if ((walls || name[0] == 'U') && std::ranges::find(vectors, name) != vectors.end()) return name;
    return vectors.size() == 1 ? vectors.front() : "";
}

bool foamHasField(const FoamCase& foam, const std::string& region, double time, const FoamField& field)
{
    return std::ranges::any_of(foam.folders, [&](const FoamPath& folder) {
        return !foamFileOf(foamFieldFile(folder, region, time, field.name)).empty();
    });
}

void requireFoamFieldAt(const FoamCase& foam, double time, const std::string& array)
{
    if (array.empty() || foam.times.empty()) return;
    if (const auto file = fileOf(foam, time, array)) {
        const FoamStream readable{*file};  // A field whose header is damaged is not among the others, and is told here.
        return;
    }
    const std::vector<FoamField> fields = foamFields(foam, foam.times);
    const FoamField* field = fieldOf(fields, array);
    if (!field) return;
    throw InputError(fmt::format("{}, time {}", foam.name, time), fmt::format("it has no '{}'", field->name),
                     field->times.size() == 1
                         ? fmt::format("time {}, the only one that has it", field->times.front())
                         : fmt::format("one of the {} times that have it, from {} to {}", field->times.size(),
                                       field->times.front(), field->times.back()));
}

std::vector<double> foamTimes(const std::string& path, const std::vector<std::string>& arrays)
{
    const FoamCase foam = findFoamCase(path);
    std::vector<double> times = foam.times;
    if (times.empty() || std::ranges::all_of(arrays, [&](const std::string& array) {
            return array.empty() || fileOf(foam, times.front(), array);
        }))
        return times;  // Not all folders are looked into for what is usual.
    const std::vector<FoamField> fields = foamFields(foam, foam.times);
    for (const std::string& array : arrays)
        if (const FoamField* field = fieldOf(fields, array))
            std::erase_if(times,
                          [&](double time) { return std::ranges::find(field->times, time) == field->times.end(); });
    return times;
}

}  // namespace aeolic
