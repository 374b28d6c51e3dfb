#include "reader/parts/vector_names.h"

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

}  // namespace

std::vector<NamedComponents> joinComponents(const std::vector<std::string>& names, bool flat)
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
            const std::size_t count = found.axes == 7 ? 3 : found.axes == 3 && flat ? 2 : 0;
            const std::string name = taken.contains(found.name) ? found.name + "XYZ" : found.name;
            if (count > 0 && found.of[components[i]->axis] == i && taken.insert(name).second) {
                joined.push_back({name, {found.of, found.of + count}});
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
