#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "description/option_table.h"
#include "description/scene_json.h"

namespace aeolic {
namespace {

using Json = nlohmann::ordered_json;

Json range(const char* kind, const NumberRule& rule)
{
    Json json{{"kind", kind}};
    const auto isBound = [](double value) { return std::abs(value) < std::numeric_limits<double>::max(); };
    if (isBound(rule.lo)) json[rule.aboveLo ? "above" : "least"] = rule.lo;
    if (isBound(rule.hi)) json["most"] = rule.hi;
    if (isBound(rule.usualLo) && isBound(rule.usualHi)) json["usual"] = {rule.usualLo, rule.usualHi};
    return json;
}

template <class Value>
Json described(const Value&, const NumberRule& rule)
{
    return range(std::is_integral_v<Value> ? "whole" : "number", rule);
}
template <std::size_t N>
Json described(const std::optional<std::array<double, N>>&, const NumberRule& rule)
{
    Json json = range("numbers", rule);
    json["count"] = N;
    return json;
}
template <class Value>
Json described(const Value&, const NameRule& rule)
{
    Json json{{"kind", "name"}, {"names", rule.names}};
    if (rule.pattern[0] != '\0') json["pattern"] = rule.pattern;
    return json;
}
Json described(bool, const SwitchRule&)
{
    return {{"kind", "switch"}};
}
Json described(const std::string&, const TextRule& rule)
{
    return {{"kind", rule.kind}};
}

}  // namespace

Json optionsDocument(std::initializer_list<std::string_view> groups)
{
    Json document = Json::object();
    const Json defaults = sceneDocument({});
    const SceneDescription scene;
    forEachOption(scene, [&](const Option& option, const auto& value, const auto& rule) {
        const char* const group = option.group.key;
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) return;
        Json json = described(value, rule);
        json["default"] = defaults[group].contains(option.key) ? defaults[group][option.key] : Json();
        document[group][option.key] = json;
    });
    return document;
}

}  // namespace aeolic
