#include "description/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "description/scene_surfaces.h"
#include "description/validate.h"

namespace aeolic {

namespace {

template <class Rule>
void parse(const std::string&, const std::string& text, std::string& value, const Rule&)
{
    value = text;
}

template <class Number>
requires std::is_arithmetic_v<Number>
void parse(const std::string& where, std::string_view text, Number& value, const NumberRule& rule)
{
    constexpr bool isWhole = std::is_integral_v<Number>;
    const auto exact = parseNumber(text);
    if (!exact) throw InputError(where, "found " + inQuotes(text), expectedNumber(rule, isWhole));
    if (isWhole) checkWhole(where, *exact, rule);
    value = Number(*exact);
}

void parse(const std::string& where, const std::string& text, bool& value, const SwitchRule&)
{
    if (text != "on" && text != "off") throw InputError(where, "found " + inQuotes(text), "on or off");
    value = text == "on";
}

template <class Enum>
requires std::is_enum_v<Enum>
void parse(const std::string& where, const std::string& text, Enum& value, const NameRule& rule)
{
    value = Enum(indexOfName(where, "found " + inQuotes(text), text, rule));
}

void parse(const std::string& where, const std::string& text, std::optional<double>& value, const NumberRule& rule)
{
    if (rule.automatic && text == "auto") return value.reset();
    double given = 0;
    parse(where, text, given, rule);
    value = given;
}

template <std::size_t N>
void parse(const std::string& where, const std::string& text, std::optional<std::array<double, N>>& value,
           const NumberRule& rule)
{
    const auto parts = splitText(text, ',');
    if (parts.size() != N)
        throw InputError(where, "found " + inQuotes(text), fmt::format("{} numbers separated by commas", N));
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) parse(where, parts[i], numbers[i], rule);
    value = numbers;
}

template <class Value, class Rule>
std::string typed(const Value& value, const Rule& rule)
{
    if constexpr (std::is_same_v<Value, std::string>)
        return value;
    else if constexpr (std::is_same_v<Value, bool>)
        return value ? "on" : "off";
    else if constexpr (std::is_enum_v<Value>)
        return std::size_t(value) < rule.names.size() ? std::string(rule.names[std::size_t(value)])
                                                      : numberText(double(value));
    else
        return numberText(double(value));
}

template <std::size_t N>
std::string typed(const std::array<double, N>& values, const NumberRule&)
{
    return numbersText(values);
}

template <class Value>
std::string typed(const std::optional<Value>& value, const NumberRule& rule)
{
    return value ? typed(*value, rule) : "";
}

const NamedView* namedView(std::string_view name)
{
    const auto* const found = std::find_if(std::begin(namedViews), std::end(namedViews),
                                           [&](const NamedView& view) { return view.name == name; });
    return found == std::end(namedViews) ? nullptr : found;
}

/// True if "name=" or a view's name starts here: a comma before it ends the value so far.
bool nameFollows(std::string_view text)
{
    text = trimmedText(text);
    const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const std::string_view name(text.begin(), std::find_if_not(text.begin(), text.end(), isLetter));
    return namedView(name) || (!name.empty() && text.substr(name.size()).starts_with('='));
}

std::vector<std::string_view> cameraItems(std::string_view text)
{
    std::vector<std::string_view> items;
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != ';' && !(text[i] == ',' && nameFollows(text.substr(i + 1)))) continue;
        items.push_back(trimmedText(text.substr(start, i - start)));
        start = i + 1;
    }
    items.push_back(trimmedText(text.substr(start)));
    if (items.size() > 1 && items.back().empty()) items.pop_back();  // A separator at the end is harmless.
    return items;
}

constexpr std::string_view cameraPrefix = "--camera ", kSurface = "--surface";

std::vector<std::string_view> cameraNames()
{
    std::vector<std::string_view> names;
    const SceneDescription scene;
    forEachOption(scene, [&](const Option& option, const auto&, const auto&) {
        const std::string_view name = option.name;
        if (name.starts_with(cameraPrefix)) names.push_back(name.substr(cameraPrefix.size()));
    });
    return names;
}

void setSize(SceneDescription& scene, const std::string& text)
{
    const auto parts = splitText(text, 'x');
    if (parts.size() != 2 || !parseNumber(parts[0]) || !parseNumber(parts[1]))
        throw InputError("--size", "found " + inQuotes(text),
                         "WIDTHxHEIGHT in pixels, each " + rangeText(options::side));
    setOption(scene, "--size width", std::string(parts[0]));
    setOption(scene, "--size height", std::string(parts[1]));
}

void setCamera(SceneDescription& scene, const std::string& text)
{
    std::set<std::string> given;
    const auto names = cameraNames();
    std::vector<std::string_view> views;
    for (const NamedView& view : namedViews) views.push_back(view.name);
    const std::string expected =
        fmt::format("one of {}, or name=value with the names {}", fmt::join(views, ", "), fmt::join(names, ", "));
    for (std::string_view item : cameraItems(text)) {
        if (const NamedView* view = namedView(item)) {
            if (given.contains("azimuth") || given.contains("elevation"))
                throw InputError("--camera", "found " + inQuotes(item) + " and other angles", "one or the other");
            scene.camera.azimuth = view->azimuthDeg;
            scene.camera.elevation = view->elevationDeg;
            given.insert({"azimuth", "elevation"});
            continue;
        }
        const std::size_t equals = item.find('=');
        const std::string name(trimmedText(item.substr(0, equals)));
        if (equals == std::string_view::npos || std::find(names.begin(), names.end(), name) == names.end())
            throw InputError("--camera", "found " + inQuotes(item),
                             expected + didYouMean(name, equals == std::string_view::npos ? views : names));
        if (!given.insert(name).second) throw InputError("--camera " + name, "found twice", "it once");
        // Spaces after the commas of a list are how people write vectors.
        std::string value;
        for (const std::string_view part : splitText(trimmedText(item.substr(equals + 1)), ','))
            value += (value.empty() ? "" : ",") + std::string(trimmedText(part));
        setOption(scene, std::string(cameraPrefix) + name, value);
    }
    const bool angles = given.contains("azimuth") || given.contains("elevation") || given.contains("roll"),
               relative = angles || given.contains("zoom");
    if (relative && given.contains("position"))
        throw InputError("--camera", fmt::format("found {} and a position", angles ? "angles" : "a zoom"),
                         "one or the other");
    if (relative) scene.camera.position.reset();
}

/// Sets an option that takes words in the place of numbers by one of these, and the numbers are not set then. False
/// where the text is no word.
bool setWord(SceneDescription& scene, std::string_view name, const std::string& text)
{
    const std::string row = std::string(name).append(wordSuffix);
    const bool isNumber = parseNumber(text.substr(0, text.find(','))).has_value();
    bool isSet = false;
    forEachOption(scene, [&](const Option& option, auto& value, const auto& rule) {
        if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>) {
            if (option.name != row) return;
            const std::string nearest = isNumber ? "" : didYouMean(text, rule.names);
            isSet = std::find(rule.names.begin(), rule.names.end(), text) != rule.names.end();
            if (!isSet && !nearest.empty())
                throw InputError(std::string(name), "found " + inQuotes(text),
                                 expectedText(rule) + ", or numbers" + nearest);
            value = {};  // A number takes its place.
            if (isSet) parse(std::string(name), text, value, rule);
        }
    });
    if (!isSet) return false;
    forEachOption(scene, [&](const Option& option, auto& value, const auto&) {
        if constexpr (requires { value.reset(); })
            if (option.name == name) value.reset();
    });
    return true;
}

}  // namespace

void setOption(SceneDescription& scene, std::string_view name, const std::string& text)
{
    if (setWord(scene, name, text)) return;
    if (name == "--size") return setSize(scene, text);
    if (name == "--camera") return setCamera(scene, text);
    if (name == contextOption.name) return setSurfaces(scene, {}, {text});
    if (name == kSurface) scene.surfaces.clear();
    forEachOption(scene, [&](const Option& option, auto& value, const auto& rule) {
        if (option.name == name) parse(option.name, text, value, rule);
    });
}

void takeOption(SceneDescription& scene, const SceneDescription& from, std::string_view name)
{
    std::vector<const void*> values;  // Both have the same rows in the same order.
    forEachOption(from, [&](const Option&, const auto& value, const auto&) { values.push_back(&value); });
    std::size_t row = 0;
    forEachOption(scene, [&](const Option& option, auto& value, const auto&) {
        const auto* theirs = static_cast<const std::decay_t<decltype(value)>*>(values[row++]);
        const std::string_view own = option.name;
        if (own == name || (own.starts_with(name) && own.substr(name.size()).starts_with(' '))) value = *theirs;
    });
}

void setSurfaces(SceneDescription& scene, const std::vector<std::string>& surfaces,
                 const std::vector<std::string>& contexts)
{
    if (surfaces.size() == 1) setOption(scene, kSurface, surfaces.front());
    if (surfaces.size() > 1) scene.surfaces.clear();
    if (surfaces.size() < 2 && contexts.empty()) return;
    if (surfaces.size() < 2) scene.surfaces = surfacesOf(scene);
    const auto add = [&](const std::vector<std::string>& specs, bool streaks) {
        for (const std::string& spec : specs) {
            if (spec.empty())
                throw InputError(streaks ? std::string(kSurface) : contextOption.name, "found ''",
                                 options::someName.expected);
            SurfaceItem item;
            item.spec = spec;
            item.streaks = streaks;
            if (!streaks) item.colorBy = "";
            scene.surfaces.push_back(item);
        }
    };
    if (surfaces.size() > 1) add(surfaces, true);
    add(contexts, false);
}

std::string optionText(const SceneDescription& scene, std::string_view name)
{
    std::string text;
    forEachOption(scene, [&](const Option& option, const auto& value, const auto& rule) {
        if (option.name == name) text = typed(value, rule);
        if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)  // A word in the place of numbers.
            if (option.name == std::string(name).append(wordSuffix) && text.empty() && std::size_t(value) > 0)
                text = typed(value, rule);
    });
    return text;
}

std::string groupText(const SceneDescription& scene, std::string_view group)
{
    std::string text;
    forEachOption(scene, [&](const Option& option, const auto& value, const auto& rule) {
        if (option.group.key != group) return;
        const std::string given = typed(value, rule);
        text += jsonName(option) + (given.empty() ? " =" : " = ") + given + "\n";
    });
    return text;
}

}  // namespace aeolic
