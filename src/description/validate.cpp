#include "description/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "aeolic/error.h"

namespace aeolic {

namespace {

/// Checks one field against its rule.
struct FieldChecker {
    const FieldNaming& naming;

    void operator()(const FieldName& field, const std::string& text, const TextRule& rule) const
    {
        checkText(naming(field), text, rule);
    }
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void operator()(const FieldName& field, Number value, const NumberRule& rule) const
    {
        checkNumber(naming(field), double(value), rule);
    }
    void operator()(const FieldName& field, int value, const NumberRule& rule) const
    {
        checkWhole(naming(field), value, rule);
    }
    void operator()(const FieldName& field, std::uint32_t value, const NumberRule& rule) const
    {
        checkWhole(naming(field), value, rule);
    }
    template <class Value>
    void operator()(const FieldName& field, const std::optional<Value>& value, const NumberRule& rule) const
    {
        if (value) (*this)(field, *value, rule);
    }
    template <std::size_t N>
    void operator()(const FieldName& field, const std::array<double, N>& values, const NumberRule& rule) const
    {
        for (double value : values) checkNumber(naming(field), value, rule);
    }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void operator()(const FieldName& field, Enum value, const EnumRule& rule) const
    {
        if (int(value) < 0 || std::size_t(value) >= rule.names.size())
            throw InputError(naming(field), fmt::format("found value {}", int(value)), expectedName(rule));
    }
    void operator()(const FieldName&, bool, const SwitchRule&) const {}
};

std::string text(const Vec3& v)
{
    return fmt::format("{},{},{}", numberText(v[0]), numberText(v[1]), numberText(v[2]));
}

/// Fields that must fit each other. Called when each is sound by itself.
void checkRelations(const SceneDescription& scene, const FieldNaming& naming)
{
    if (const auto& range = scene.shading.colorRange; range && !((*range)[0] < (*range)[1]))
        throw InputError(naming({"shading", "colorRange", "--color-range"}),
                         fmt::format("found {},{}", numberText((*range)[0]), numberText((*range)[1])),
                         "the low end first, and below the high end");

    if (scene.time.moment && scene.time.range)
        throw InputError(naming({"time", "range", "--times"}),
                         "found together with " + naming({"time", "moment", "--time"}), "one or the other");

    const CameraOptions& camera = scene.camera;
    if (camera.position && camera.focal && *camera.position == *camera.focal)
        throw InputError(naming({"camera", "focal", "--camera focal"}),
                         "found the camera's position " + text(*camera.focal), "another point, to look at");
    if (camera.up && *camera.up == Vec3{0, 0, 0})
        throw InputError(naming({"camera", "up", "--camera up"}), "found 0,0,0", "a direction");
}

}  // namespace

std::string jsonName(const FieldName& field)
{
    return std::string(field.group) + "." + field.key;
}

std::string optionName(const FieldName& field)
{
    return field.option;
}

void validate(const SceneDescription& scene, const FieldNaming& naming)
{
    forEachField(scene, FieldChecker{naming});
    checkRelations(scene, naming);
}

}  // namespace aeolic
