#pragma once

/// The names that the choices of a scene have in texts: in the JSON, on the command line and on the page.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The names of an enum's values, in their order.
template <class Choice>
inline constexpr auto choiceNames = nullptr;
template <>
inline constexpr auto choiceNames<CellValues> = std::to_array<std::string_view>({"smooth", "steps"});
template <>
inline constexpr auto choiceNames<Faces> = std::to_array<std::string_view>({"both", "front"});
template <>
inline constexpr auto choiceNames<FieldPrecision> = std::to_array<std::string_view>({"float", "half"});
template <>
inline constexpr auto choiceNames<LicMethod> = std::to_array<std::string_view>({"none", "direct", "hierarchical"});
template <>
inline constexpr auto choiceNames<Integrator> = std::to_array<std::string_view>({"euler", "rk2", "rk4"});
template <>
inline constexpr auto choiceNames<Style> = std::to_array<std::string_view>({"dense", "oriented"});
template <>
inline constexpr auto choiceNames<Kernel> = std::to_array<std::string_view>({"box", "hann"});
template <>
inline constexpr auto choiceNames<FlowMotion> = std::to_array<std::string_view>({"off", "loop"});
template <>
inline constexpr auto choiceNames<Magnitude> = std::to_array<std::string_view>({"none", "contrast", "length"});
template <>
inline constexpr auto choiceNames<RangeOf> = std::to_array<std::string_view>({"data", "robust"});
template <>
inline constexpr auto choiceNames<MomentOf> = std::to_array<std::string_view>({"first", "last"});
template <>
inline constexpr auto choiceNames<Streaks> = std::to_array<std::string_view>({"plain", "even"});
template <>
inline constexpr auto choiceNames<BackendChoice> = std::to_array<std::string_view>({"auto", "cpu", "gl"});
template <>
inline constexpr auto choiceNames<Balance> = std::to_array<std::string_view>({"static", "timing", "pixels", "hybrid"});
template <>
inline constexpr auto choiceNames<BrickChoice> = std::to_array<std::string_view>({"on", "off", "auto"});
template <>
inline constexpr auto choiceNames<GuardChoice> = std::to_array<std::string_view>({"bound", "estimate"});
template <>
inline constexpr auto choiceNames<GuardRowsChoice> = std::to_array<std::string_view>({"project", "receive", "auto"});

/// The value's name. The value must be one of the enum's.
template <class Choice>
requires std::is_enum_v<Choice> std::string_view nameOf(Choice choice)
{
    return choiceNames<Choice>[std::size_t(choice)];
}

/// The value of that name, or nothing.
template <class Choice>
std::optional<Choice> choiceNamed(std::string_view name)
{
    const auto& names = choiceNames<Choice>;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return Choice(found - names.begin());
}

}  // namespace aeolic
