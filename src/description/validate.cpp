#include "description/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "aeolic/error.h"

namespace aeolic {

namespace {

/// Checks one option against its rule.
struct OptionChecker {
    const OptionNaming& naming;

    template <class Value, class Rule>
    void operator()(const Option& option, const Value& value, const Rule& rule) const
    {
        if constexpr (requires { value.has_value(); }) {
            if (value) (*this)(option, *value, rule);
        } else if constexpr (std::is_same_v<Value, std::string>) {
            checkText(naming(option), value, rule);
        } else if constexpr (std::is_enum_v<Value>) {
            if (int(value) < 0 || std::size_t(value) >= rule.names.size())
                throw InputError(naming(option), fmt::format("found value {}", int(value)), expectedText(rule));
        } else if constexpr (std::is_floating_point_v<Value>) {
            checkNumber(naming(option), value, rule);
        } else if constexpr (std::is_same_v<Rule, NumberRule> && std::is_integral_v<Value>) {
            checkWhole(naming(option), value, rule);
        } else if constexpr (std::is_same_v<Rule, NumberRule>) {
            for (const double number : value) checkNumber(naming(option), number, rule);
        } else {
            static_assert(std::is_same_v<Value, bool>, "values of this type would not be checked");
        }
    }
};

/// Throws InputError where a range of colours does not ascend. `where()`: what messages call the range.
template <class Where>
void checkColorRange(const std::optional<std::array<double, 2>>& range, const Where& where)
{
    if (range && !((*range)[0] < (*range)[1]))
        throw InputError(where(), "found " + numbersText(*range), "the low end first, and below the high end");
}

/// Several surfaces in one picture.
void checkSurfaces(const SceneDescription& scene, const OptionNaming& naming)
{
    const std::vector<SurfaceItem>& items = scene.surfaces;
    if (items.empty()) return;
    const auto named = [&](std::size_t i, const char* field) {
        const std::string key = surfaceKey(i);
        return naming(Option{{key.c_str(), "Data"}, field, "", "", ""});
    };
    if (items.size() > options::mostSurfaces)
        throw InputError("surfaces", fmt::format("found {}", items.size()),
                         fmt::format("at most {} in one picture", options::mostSurfaces));
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].spec == "image") throw InputError(named(i, "spec"), "found 'image' among several", "it alone");
        checkColorRange(items[i].colorRange, [&] { return named(i, "colorRange"); });
    }
    if (std::none_of(items.begin(), items.end(), [](const SurfaceItem& item) { return item.streaks; }))
        throw InputError("surfaces", "none of them has streaks", "at least one with streaks");
}

/// Fields that must fit each other. Called when each is sound by itself.
void checkRelations(const SceneDescription& scene, const OptionNaming& naming)
{
    const auto named = [&](std::string_view name) {
        std::string text;
        forEachOption(scene, [&](const Option& option, const auto&, const auto&) {
            if (option.name == name) text = naming(option);
        });
        return text;
    };
    checkColorRange(scene.shading.colorRange, [&] { return named("--color-range"); });

    if (const auto& range = scene.shading.colorRange;
        range && colorScaleOf(scene.shading.colorScale).kind == ColorScale::Kind::log && !((*range)[0] > 0))
        throw InputError(named("--color-range"), "found a low end of " + numberText((*range)[0]),
                         "one above 0, with " + named("--color-scale") + " log");

    if (scene.time.moment && scene.time.range)
        throw InputError(named("--time-range"), "found together with " + named("--time"), "one or the other");

    if (scene.time.momentOf != MomentOf::first && scene.time.range)
        throw InputError(named("--time-range"), "found together with " + named("--time") + " last", "one or the other");

    const CameraOptions& camera = scene.camera;
    if (camera.position && camera.focal && *camera.position == *camera.focal)
        throw InputError(named("--camera focal"), "found the camera's position " + numbersText(*camera.focal),
                         "another point, to look at");
    // A whole surface fits so narrow a view only from so far away that its depths are all the same to a float.
    if (!camera.position && camera.fov < 1)
        throw InputError(named("--camera fov"), "found " + numberText(camera.fov),
                         "1 or more, or a position of the camera");
    if (camera.up && *camera.up == Vec3{0, 0, 0}) throw InputError(named("--camera up"), "found 0,0,0", "a direction");
}

}  // namespace

std::string jsonName(const Option& option)
{
    return std::string(option.group.key) + "." + option.key;
}

std::string surfaceKey(std::size_t index)
{
    return fmt::format("surfaces[{}]", index);
}

std::string commandLineName(const Option& option)
{
    return option.name[0] == '\0' ? jsonName(option) : option.name;
}

void validate(const SceneDescription& scene, const OptionNaming& naming)
{
    forEachOption(scene, OptionChecker{naming});
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const std::string key = surfaceKey(i);
        forEachItemOption(scene.surfaces[i], key.c_str(), OptionChecker{naming});
    }
    checkSurfaces(scene, naming);
    checkRelations(scene, naming);
}

}  // namespace aeolic
