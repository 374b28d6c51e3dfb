#include "description/scene_json.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "description/builtin_names.h"
#include "description/colormap.h"
#include "description/scene_surfaces.h"
#include "description/validate.h"

namespace aeolic {

namespace {

using Json = nlohmann::ordered_json;

constexpr int sceneVersion = 1;
constexpr const char* kSurfaces = "surfaces";
constexpr int deepestNesting = 8;                   // The format needs three levels.
constexpr std::size_t largestFileBytes = 1u << 20;  // A scene is a few hundred bytes.

struct OptionWriter {
    Json& document;

    template <class Value, class Rule>
    void operator()(const Option& option, const Value& value, const Rule&) const
    {
        if constexpr (requires { value.has_value(); }) {
            if (value) document[option.group.key][option.key] = *value;
        } else if constexpr (std::is_enum_v<Value>) {
            // The word that stands in the place of an option's numbers, where none was said.
            if (std::string_view(option.name).ends_with(wordSuffix) && value == Value{}) return;
            document[option.group.key][option.key] = nameOf(value);
        } else {
            document[option.group.key][option.key] = value;
        }
    }
};

std::string found(const Json& value)
{
    if (value.is_object()) return "found an object";
    if (value.is_array()) return fmt::format("found a list of {}", value.size());
    if (value.is_string()) return "found the text " + inQuotes(value.get_ref<const std::string&>());
    if (value.is_number_float()) return "found " + numberText(value.get<double>());
    return "found " + value.dump();
}

/// Takes one field's value out of the document, if it is there. Ranges that no type could hold are refused here,
/// everything else by validate().
struct OptionReader {
    const Json& document;
    const std::string& source;

    template <class Value, class Rule>
    void operator()(const Option& option, Value& value, const Rule& rule) const
    {
        const auto group = document.find(option.group.key);
        if (group == document.end()) return;
        const auto item = group->find(option.key);
        if (item != group->end()) read(source + jsonName(option), *item, value, rule);
    }

    template <class Rule>
    static void read(const std::string& where, const Json& item, std::string& value, const Rule& rule)
    {
        if (!item.is_string()) throw InputError(where, found(item), "text: " + expectedText(rule));
        value = item.get<std::string>();
    }
    template <class Number>
    requires std::is_arithmetic_v<Number>
    static void read(const std::string& where, const Json& item, Number& value, const NumberRule& rule)
    {
        constexpr bool isWhole = std::is_integral_v<Number>;
        if (!item.is_number()) throw InputError(where, found(item), expectedNumber(rule, isWhole));
        if (isWhole) checkWhole(where, item.get<double>(), rule);
        value = Number(item.get<double>());
    }
    static void read(const std::string& where, const Json& item, bool& value, const SwitchRule&)
    {
        if (!item.is_boolean()) throw InputError(where, found(item), "true or false");
        value = item.get<bool>();
    }
    template <class Choice>
    requires std::is_enum_v<Choice>
    static void read(const std::string& where, const Json& item, Choice& value, const NameRule& rule)
    {
        const std::string name = item.is_string() ? item.get<std::string>() : "";
        value = Choice(indexOfName(where, found(item), name, rule));
    }
    template <class Rule>
    static void read(const std::string& where, const Json& item, std::optional<std::string>& value, const Rule& rule)
    {
        read(where, item, value.emplace(), rule);
    }
    static void read(const std::string& where, const Json& item, std::optional<double>& value, const NumberRule& rule)
    {
        if (rule.automatic && item.is_string() && item.get<std::string>() == "auto") return value.reset();
        read(where, item, value.emplace(), rule);
    }
    template <std::size_t N>
    static void read(const std::string& where, const Json& item, std::optional<std::array<double, N>>& value,
                     const NumberRule& rule)
    {
        if (!item.is_array() || item.size() != N)
            throw InputError(where, found(item), fmt::format("a list of {} numbers", N));
        value.emplace();
        for (std::size_t i = 0; i < N; ++i) read(fmt::format("{}[{}]", where, i), item[i], (*value)[i], rule);
    }
};

/// Where byte `offset` stands, for a person with an editor.
std::string lineAndColumn(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0.
    return fmt::format("line {}, column {}", line, before.size() - lineStart + 1);
}

/// The text as a document. Refuses what the parser lets through: repeated keys (it keeps the last) and deep nesting.
Json parsed(std::string_view text, const std::string& source)
{
    std::vector<std::set<std::string>> keys;
    const auto refuseRepeats = [&](int, Json::parse_event_t event, Json& value) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) {
            if (keys.size() >= deepestNesting)
                throw InputError(source + "nesting", fmt::format("found more than {} levels", deepestNesting),
                                 "a scene");
            keys.emplace_back();
        } else if (event == Event::object_end || event == Event::array_end) {
            keys.pop_back();
        } else if (event == Event::key && !keys.back().insert(value.get<std::string>()).second) {
            throw InputError(source + inQuotes(value.get_ref<const std::string&>()), "found twice", "each key once");
        }
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), refuseRepeats);
    } catch (const Json::parse_error& error) {
        const std::size_t at = error.byte > 0 ? error.byte - 1 : 0;
        const std::string what = at < text.size() ? inQuotes(text.substr(at, 1)) : "the end of the text";
        throw InputError(source + lineAndColumn(text, at), "found " + what, "valid JSON");
    } catch (const Json::out_of_range&) {
        throw InputError(source + "document", "found a number beyond 1e308", "finite numbers");
    }
}

/// Throws where `object` has a key that `complete` has not. `where` stands in front of the key.
void checkKeys(const Json& object, const Json& complete, const std::string& where)
{
    std::vector<std::string> known;
    for (const auto& [key, value] : complete.items()) known.push_back(key);
    for (const auto& [key, value] : object.items())
        if (!complete.contains(key))
            throw InputError(where + inQuotes(key), "unknown key",
                             fmt::format("one of {}", fmt::join(known, ", ")) + didYouMean(key, known));
}

/// The same for the list of surfaces.
void checkItems(const Json& items, const Json& complete, const std::string& where)
{
    if (!items.is_array()) throw InputError(where, found(items), "a list of objects");
    if (items.size() > options::mostSurfaces)
        throw InputError(where, found(items), fmt::format("at most {} surfaces", options::mostSurfaces));
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string item = fmt::format("{}[{}]", where, i);
        if (!items[i].is_object()) throw InputError(item, found(items[i]), "an object");
        checkKeys(items[i], complete, item + ": ");
    }
}

/// Throws where a group is not an object, or where a scene has no such key. `complete` holds every group and key.
void checkGroups(const Json& document, const Json& complete, const std::string& source)
{
    if (!document.is_object()) throw InputError(source + "document", found(document), "an object");
    checkKeys(document, complete, source);
    for (const auto& [group, items] : document.items()) {
        if (group == "version") {
            if (items != sceneVersion)
                throw InputError(source + "version", found(items), fmt::format("{}", sceneVersion));
            continue;
        }
        if (group == kSurfaces) {
            checkItems(items, complete[group], source + group);
            continue;
        }
        if (!items.is_object()) throw InputError(source + group, found(items), "an object");
        checkKeys(items, complete[group], source + group + ": ");
    }
}

/// Every group and key a scene can have, with an empty value.
Json allKeys()
{
    Json complete{{"version", sceneVersion}};
    SceneDescription scene;
    forEachOption(scene,
                  [&](const Option& option, auto&, const auto&) { complete[option.group.key][option.key] = nullptr; });
    SurfaceItem item;
    forEachItemOption(item, kSurfaces, [&](const Option& option, auto&, const auto&) {
        complete[option.group.key][option.key] = nullptr;
    });
    return complete;
}

std::string prefixOf(const std::string& source)
{
    return source.empty() ? "" : source + ": ";
}

std::string fileText(const std::string& path)
{
    const std::string expected = "a scene file (JSON)";
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path, "found a folder", expected);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path, std::string("cannot be opened (") + std::strerror(errno) + ")", expected);
    std::string text(largestFileBytes + 1, '\0');
    file.read(text.data(), std::streamsize(text.size()));
    if (file.bad()) throw InputError(path, "cannot be read", expected);
    text.resize(std::size_t(file.gcount()));
    if (text.size() > largestFileBytes) throw InputError(path, "found more than 1 MiB", expected);
    return text;
}

}  // namespace

Json sceneDocument(const SceneDescription& scene)
{
    validate(scene);  // An enum without a name has no text.
    Json document{{"version", sceneVersion}};
    forEachOption(scene, OptionWriter{document});
    for (const SurfaceItem& item : scene.surfaces) {
        Json one;
        forEachItemOption(item, kSurfaces, OptionWriter{one});
        document[kSurfaces].push_back(one[kSurfaces]);
    }
    if (!scene.surfaces.empty()) document["surface"].erase("spec");
    return document;
}

std::string sceneToJson(const SceneDescription& scene)
{
    const Json document = sceneDocument(scene);
    try {
        return document.dump(2) + "\n";
    } catch (const Json::type_error&) {
        throw InputError("scene", "found text that is not UTF-8", "names and file names in UTF-8");
    }
}

SceneDescription sceneFromJson(std::string_view text, const std::string& source)
{
    return sceneFromDocument(parsed(text, prefixOf(source)), source);
}

SceneDescription sceneFromDocument(const Json& document, const std::string& source)
{
    static const Json known = allKeys();
    const std::string prefix = prefixOf(source);
    checkGroups(document, known, prefix);
    SceneDescription scene;
    forEachOption(scene, OptionReader{document, prefix});
    if (document.contains(kSurfaces)) {
        const Json& items = document[kSurfaces];
        for (std::size_t i = 0; i < items.size(); ++i) {
            const std::string key = surfaceKey(i);
            const Json one{{key, items[i]}};
            forEachItemOption(scene.surfaces.emplace_back(), key.c_str(), OptionReader{one, prefix});
        }
        if (!items.empty() && document.contains("surface") && document["surface"].contains("spec"))
            throw InputError(prefix + "surface.spec", "found together with surfaces", "one or the other");
    }
    validate(scene, [&](const Option& option) { return prefix + jsonName(option); });
    return scene;
}

SceneInFile readSceneText(std::string_view text, const std::string& source)
{
    const Json document = parsed(text, prefixOf(source));
    SceneInFile file{sceneFromDocument(document, source)};
    file.namesSurface =
        !file.scene.surfaces.empty() || (document.contains("surface") && document["surface"].contains("spec"));
    return file;
}

SceneInFile readSceneFile(const std::string& path)
{
    SceneInFile file = readSceneText(fileText(path), path);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    renameFiles(file.scene, [&](const std::string& name) { return (folder / name).string(); });
    return file;
}

void renameFiles(SceneDescription& scene, const std::function<std::string(const std::string&)>& named)
{
    const auto renameSurface = [&](std::string& spec) {
        if (parseSurfaceSpec(spec).kind == SurfaceSpec::Kind::file) spec = named(spec);
    };
    const auto renameColorMap = [&](std::string& name) {
        if (isColorMapFile(name)) name = named(name);
    };
    renameSurface(scene.surface.spec);
    for (SurfaceItem& item : scene.surfaces) {
        renameSurface(item.spec);
        if (item.colormap) renameColorMap(*item.colormap);
    }
    if (!scene.field.spec.empty() && !isBuiltinFlow(scene.field.spec)) scene.field.spec = named(scene.field.spec);
    renameColorMap(scene.shading.colormap);
}

void requireSurface(const SceneDescription& scene, bool named)
{
    if (named) return;
    const std::string& field = scene.field.spec;
    const bool isBuiltin = isBuiltinFlow(field), isMisspelt = !didYouMean(nameInSpec(field), builtinFlowNames).empty();
    if (!field.empty() && !isBuiltin && !isMisspelt)  // Who reads it tells how a built-in is spelt.
        throw InputError("--surface", "found none",
                         "a file, boundary, slice:OX,OY,OZ:NX,NY,NZ, isosurface:ARRAY=VALUE or image (the teapot is "
                         "drawn in built-in fields alone)");
    if (!scene.surfaces.empty())
        throw InputError("--surface", "found none beside " + std::string(contextOption.name),
                         "a surface with streaks (the teapot is drawn alone)");
}

void chooseDefaultField(SceneDescription& scene)
{
    if (!scene.field.spec.empty() || !scene.field.vectors.empty()) return;
    for (const SurfaceItem& item : surfacesOf(scene))
        if (item.streaks && !item.vectors && isBuiltinSurface(item.spec)) scene.field.spec = "abc";
}

}  // namespace aeolic
