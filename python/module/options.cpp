#include "options.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include "aeolic/error.h"
#include "data/load/field/plane_image.h"
#include "data/load/loaded_scene.h"
#include "description/option_help.h"
#include "description/option_names.h"
#include "description/option_table.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"

namespace aeolic::python {

namespace py = pybind11;

namespace {

std::string typeOf(const std::string&, const TextRule&)
{
    return "str";
}
std::string typeOf(bool, const SwitchRule&)
{
    return "bool";
}
std::string typeOf(double, const NumberRule&)
{
    return "float";
}
std::string typeOf(const std::optional<double>&, const NumberRule& rule)
{
    return rule.automatic ? "float | Literal[\"auto\"]" : "float";
}
template <class Whole>
requires std::is_integral_v<Whole> std::string typeOf(Whole, const NumberRule&)
{
    return "int";
}
template <std::size_t N>
std::string typeOf(const std::optional<std::array<double, N>>&, const NumberRule&)
{
    return "Sequence[float]";
}
template <class Name>
std::string typeOf(const Name&, const NameRule& rule)
{
    if (rule.isOther) return "str";
    std::string names;
    for (const std::string_view name : rule.names) names += (names.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    return "Literal[" + names + "]";
}

/// What belongs to the option, or to the items of a compound one.
struct Row {
    std::string key, group, type, initial;
};

Row rowOf(const std::string& name)
{
    Row row;
    const SceneDescription defaults;
    forEachOption(defaults, [&](const Option& option, const auto& value, const auto& rule) {
        if (option.name == name)
            row = {jsonName(option), option.group.key, typeOf(value, rule), optionText(defaults, name)};
        if (std::string_view(option.name).starts_with(name + " ")) row.group = option.group.key;
    });
    if (name == "--size") row.type = "Sequence[int] | str";
    if (name == "--camera") row.type = "Mapping[str, Any] | str";
    if (name == contextOption.name) row = {"", options::surface.key, "Sequence[str] | str", ""};
    return row;
}

/// The size of a picture that nobody has said. `unused`: somebody has, so that none is needed.
OutputOptions withPlaneSize(OutputOptions output, const SceneDescription& scene, const Data& memory, bool unused)
{
    try {
        if (const auto size = planeSize(scene, memory)) {
            output.width = size->width;
            output.height = size->height;
        }
    } catch (const InputError&) {
        if (!unused) throw;
    }
    return output;
}

}  // namespace

py::list optionTable()
{
    py::list table;
    for (const OptionHelp& help : optionsHelp()) {
        const Row row = rowOf(help.name);
        py::dict entry;
        entry["name"] = pythonName(help.name);
        entry["option"] = help.name;
        entry["key"] = row.key;
        entry["group"] = row.group;
        entry["type"] = row.type;
        entry["default"] = row.initial;
        entry["help"] = inPythonsWords(help.text);
        table.append(entry);
    }
    return table;
}

SceneInFile startOf(const GivenScene& given)
{
    if (given.file) return readSceneFile(*given.file);
    return given.text ? readSceneText(*given.text, "scene") : SceneInFile{};
}

SceneDescription sceneOf(SceneInFile& start, bool isGiven, const Texts& given, const Surfaces& surfaces,
                         const Data& memory)
{
    SceneDescription scene = start.scene;
    if (memory.surface) scene.surfaces.clear();
    nameMemory(scene, memory);
    if (!surfaces.items.empty()) scene.surfaces = sceneFromJson(R"({"surfaces":)" + surfaces.items + "}", "").surfaces;
    scene = changed(std::move(scene), given);
    setSurfaces(scene, {}, surfaces.contexts);
    validate(scene, commandLineName);
    requireSurface(scene,
                   start.namesSurface || memory.surface || !surfaces.items.empty() || given.contains("--surface"));
    chooseDefaultField(scene);
    if (!isGiven) start.scene.output = withPlaneSize(start.scene.output, scene, memory, given.contains("--size"));
    if (!given.contains("--size")) takeOption(scene, start.scene, "--size");
    return scene;
}

SceneDescription changed(SceneDescription scene, const Texts& given, const SceneDescription& start,
                         const std::vector<std::string>& withdrawn)
{
    for (const std::string& name : withdrawn) takeOption(scene, start, name);
    return changed(std::move(scene), given);
}

SceneDescription changed(SceneDescription scene, const Texts& given)
{
    for (const auto& [name, text] : given) setOption(scene, name, text);
    validate(scene, commandLineName);
    return scene;
}

}  // namespace aeolic::python
