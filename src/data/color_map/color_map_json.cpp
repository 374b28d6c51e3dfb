#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "aeolic/error.h"
#include "data/color_map/color_map_file.h"
#include "description/option_rules.h"

namespace aeolic {
namespace {

using Json = nlohmann::json;

constexpr const char* expectedMap = "a colour map as ParaView exports it: [{\"RGBPoints\": [value, r, g, b, …]}]";

double numberIn(const Json& list, std::size_t i, const std::string& where)
{
    if (!list[i].is_number())
        throw InputError(fmt::format("{}[{}]", where, i), "found " + std::string(list[i].type_name()), "a number");
    return list[i].get<double>();
}

/// Files write switches as 0 and 1, or as false and true.
bool isOn(const Json& value)
{
    return value.is_boolean() ? value.get<bool>() : value == 1;
}

/// The colour under `key`, where there is one; and, if `use` names a switch, where that is on.
std::optional<Color> colorIn(const Json& map, const std::string& path, const char* key, const char* use)
{
    if (use && !(map.contains(use) && isOn(map[use]))) return std::nullopt;
    if (!map.contains(key)) return std::nullopt;
    const std::string where = path + ": " + key;
    const Json& list = map[key];
    if (!list.is_array() || list.size() != 3) throw InputError(where, "not a list of three", "red, green, blue");
    return colorOfParts(where, {numberIn(list, 0, where), numberIn(list, 1, where), numberIn(list, 2, where)});
}

/// The first preset of the file. A file may be one, or a list of them.
const Json& presetIn(const Json& document, const std::string& path)
{
    const Json& preset = document.is_array() && !document.empty() ? document.front() : document;
    if (!preset.is_object()) throw InputError(path, "found " + std::string(preset.type_name()), expectedMap);
    if (preset.contains("IndexedColors") && !preset.contains("RGBPoints"))
        throw InputError(path + ": IndexedColors", "found colours for categories", "RGBPoints, colours at values");
    return preset;
}

}  // namespace

ColorPoints colorPointsFromJson(const std::string& text, const std::string& path)
{
    Json document;
    try {
        document = Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(path, fmt::format("it is not well-formed JSON at byte {}", error.byte), expectedMap);
    } catch (const Json::out_of_range&) {
        throw InputError(path, "found a number beyond 1e308", expectedMap);
    }
    const Json& preset = presetIn(document, path);
    const std::string where = path + ": RGBPoints";
    if (!preset.contains("RGBPoints")) throw InputError(where, "missing", expectedMap);
    const Json& list = preset["RGBPoints"];
    if (!list.is_array()) throw InputError(where, "found " + std::string(list.type_name()), "a list of numbers");
    if (list.size() % 4 != 0)
        throw InputError(where, fmt::format("found {} numbers", list.size()), "four for each point: value, r, g, b");
    ColorPoints map;
    for (std::size_t i = 0; i < list.size(); i += 4)
        map.points.push_back(
            {numberIn(list, i, where),
             {numberIn(list, i + 1, where), numberIn(list, i + 2, where), numberIn(list, i + 3, where)}});
    if (preset.contains("ColorSpace")) {
        const Json& space = preset["ColorSpace"];
        if (!space.is_string()) throw InputError(path + ": ColorSpace", "not a text", "a name, as \"RGB\"");
        map.space = colorSpaceNamed(path + ": ColorSpace", space.get<std::string>());
    }
    if (map.space == ColorSpace::hsv && preset.contains("HSVWrap") && isOn(preset["HSVWrap"]))
        map.space = ColorSpace::hsvWrapped;
    map.nan = colorIn(preset, path, "NanColor", nullptr);
    map.below = colorIn(preset, path, "BelowRangeColor", "UseBelowRangeColor");
    map.above = colorIn(preset, path, "AboveRangeColor", "UseAboveRangeColor");
    return map;
}

}  // namespace aeolic
