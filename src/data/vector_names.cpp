#include "data/vector_names.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace aeolic {
namespace {

bool isSeparator(char c)
{
    return c == '_' || c == '-' || c == ' ' || c == '.';
}

/// Which component of what a name is.
struct Component {
    std::string stem;  ///< The name with a mark in the place of its letter, so that "xU" and "Ux" differ.
    std::string name;  ///< Of the vector.
    std::size_t axis;
};

std::optional<std::size_t> axisOf(char letter, std::string_view letters)
{
    const std::size_t at = letters.find(letter);
    return at == std::string_view::npos ? std::nullopt : std::optional<std::size_t>(at);
}

std::string trimmed(std::string name)
{
    while (!name.empty() && isSeparator(name.back())) name.pop_back();
    name.erase(0, std::min(name.find_first_not_of("_- ."), name.size()));
    return name;
}

/// "VelocityX", "vel_x", "x-velocity", "Velocity[X]"; "U" alone.
std::optional<Component> componentOf(const std::string& name)
{
    for (const char* letters : {"XYZ", "xyz"}) {
        std::string_view rest = name;
        if (rest.size() > 3 && rest.ends_with(']') && rest[rest.size() - 3] == '[') {
            if (const auto axis = axisOf(rest[rest.size() - 2], letters))
                return Component{name.substr(0, name.size() - 2) + letters[0] + "]", name.substr(0, name.size() - 3),
                                 *axis};
        }
        if (rest.size() < 2) break;
        // The front goes first: "velocity" ends in a letter of an axis.
        if (const auto axis = axisOf(rest.front(), letters); axis && rest.size() > 2 && isSeparator(rest[1]))
            return Component{letters[0] + name.substr(1), trimmed(name.substr(1)), *axis};
        if (const auto axis = axisOf(rest.back(), letters); axis && !trimmed(name.substr(0, name.size() - 1)).empty())
            return Component{name.substr(0, name.size() - 1) + letters[0], trimmed(name.substr(0, name.size() - 1)),
                             *axis};
    }
    for (const char* letters : {"UVW", "uvw"})
        if (name.size() == 1)
            if (const auto axis = axisOf(name[0], letters)) return Component{letters, letters, *axis};
    return std::nullopt;
}

/// "vel_0", "vel[0]": of those that are counted.
std::optional<Component> countedComponentOf(const std::string& name)
{
    std::string_view rest = name;
    const bool inBrackets = rest.ends_with(']');
    if (inBrackets) rest.remove_suffix(1);
    if (rest.size() < 3) return std::nullopt;
    const char before = rest[rest.size() - 2];
    const auto axis = axisOf(rest.back(), "012");
    const bool isCounted = inBrackets ? before == '[' : isSeparator(before) || before == ':';
    const std::string own = trimmed(std::string(rest.substr(0, rest.size() - 2)));
    if (!axis || !isCounted || own.empty()) return std::nullopt;
    return Component{std::string(rest.substr(0, rest.size() - 1)) + "0", own, *axis};
}

/// What follows the last of three counted ones, if there is a fourth.
std::string fourthOf(const std::string& stem)
{
    return stem.substr(0, stem.size() - 1) + "3" + (stem[stem.size() - 2] == '[' ? "]" : "");
}

}  // namespace

std::vector<NamedComponents> joinComponents(const std::vector<std::string>& names, bool flat, bool counted,
                                            std::size_t across)
{
    struct Found {
        std::string name;
        std::size_t of[3];
        int axes = 0;  // A bit for each that was found.
    };
    std::map<std::string, Found> stems;
    std::vector<std::optional<Component>> components;
    for (std::size_t i = 0; i < names.size(); ++i) {
        components.push_back(componentOf(names[i]));
        if (!components[i] && counted) {
            components[i] = countedComponentOf(names[i]);
            if (components[i] && std::find(names.begin(), names.end(), fourthOf(components[i]->stem)) != names.end())
                components[i].reset();
        }
        if (!components[i]) continue;
        Found& found = stems[components[i]->stem];
        const int bit = 1 << components[i]->axis;
        if (found.axes & bit) continue;  // The name comes twice.
        found.name = components[i]->name;
        found.of[components[i]->axis] = i;
        found.axes |= bit;
    }
    std::vector<NamedComponents> joined;
    std::set<std::string> taken(names.begin(), names.end());
    std::vector<bool> used(names.size(), false);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (used[i]) continue;
        if (components[i]) {
            const Found& found = stems[components[i]->stem];
            const std::size_t count = found.axes == 7 ? 3 : flat && found.axes == (7 ^ 1 << across) ? 2 : 0;
            const std::string name = taken.contains(found.name) ? found.name + "XYZ" : found.name;
            if (count > 0 && found.of[components[i]->axis] == i && taken.insert(name).second) {
                NamedComponents& vector = joined.emplace_back(NamedComponents{name, {}});
                for (std::size_t c = 0; c < count; ++c)
                    vector.of.push_back(found.of[axisOfComponent(c, count, across)]);
                for (const std::size_t component : joined.back().of) used[component] = true;
                continue;
            }
        }
        joined.push_back({names[i], {i}});
        used[i] = true;
    }
    return joined;
}

}  // namespace aeolic
