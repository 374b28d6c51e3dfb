#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace aeolic {

/// The parts of a `ShadingOptions::colorBy`: [surface:|field:][point:|cell:]NAME[:mag|:x|:y|:z|:normal|:tangential].
struct ColorBy {
    enum class Of { surface, field };
    static constexpr std::string_view kSurfacePrefix = "surface:", kFieldPrefix = "field:";

    std::optional<Of> of;  ///< Whose array it is; none: the field's, or else the surface's.
    std::string name;      ///< What stands behind that prefix, or empty: no colours.

    bool mayBeOfSurface() const { return of != Of::field; }
    bool mayBeOfField() const { return of != Of::surface; }
};

/// What of an array's values a scalar is. `normal` and `tangential` are parts of the vectors on the surface: signed
/// along the surface's normal, and the length of what lies in the surface.
enum class ArrayPart : std::uint8_t { whole, length, x, y, z, normal, tangential };

/// Needs the surface's normal.
inline bool needsNormal(ArrayPart part)
{
    return part == ArrayPart::normal || part == ArrayPart::tangential;
}

/// An array as the user names it, [point:|cell:]NAME[:mag|:x|:y|:z|:normal|:tangential], where no array has the whole
/// text as its name.
struct ArrayRef {
    std::string name;
    std::optional<bool> onPoints;  ///< None: on points, else on cells.
    ArrayPart part = ArrayPart::whole;
};

/// What follows an array's name where that part of it is meant: ":mag", ":x"; empty for the whole.
inline std::string_view suffixOf(ArrayPart part)
{
    constexpr std::string_view suffixes[] = {"", ":mag", ":x", ":y", ":z", ":normal", ":tangential"};
    return suffixes[std::size_t(part)];
}

inline ArrayRef parseArray(std::string text)
{
    constexpr std::pair<std::string_view, bool> places[] = {{"point:", true}, {"cell:", false}};
    ArrayRef ref;
    using enum ArrayPart;
    for (const ArrayPart part : {length, x, y, z, normal, tangential})
        if (ref.part == whole && text.ends_with(suffixOf(part))) {
            ref.part = part;
            text.resize(text.size() - suffixOf(part).size());
        }
    for (const auto& [prefix, onPoints] : places)
        if (!ref.onPoints && text.starts_with(prefix)) {
            ref.onPoints = onPoints;
            text.erase(0, prefix.size());
        }
    ref.name = std::move(text);
    return ref;
}

/// What legends call that part of an array: "p", "|U|", "U:x".
inline std::string labelOf(const std::string& name, ArrayPart part)
{
    return part == ArrayPart::length ? "|" + name + "|" : name + std::string(suffixOf(part));
}

/// Which component it is; nothing where it is none.
inline std::optional<int> componentOf(ArrayPart part)
{
    return part < ArrayPart::x || part > ArrayPart::z ? std::nullopt : std::optional(int(part) - int(ArrayPart::x));
}

inline ColorBy parseColorBy(const std::string& text)
{
    if (text.starts_with(ColorBy::kSurfacePrefix))
        return {ColorBy::Of::surface, text.substr(ColorBy::kSurfacePrefix.size())};
    if (text.starts_with(ColorBy::kFieldPrefix)) return {ColorBy::Of::field, text.substr(ColorBy::kFieldPrefix.size())};
    return {std::nullopt, text};
}

}  // namespace aeolic
