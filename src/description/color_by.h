#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aeolic {

/// The parts of a `ShadingOptions::colorBy`: [surface:|field:]NAME[:mag].
struct ColorBy {
    enum class Of { surface, field };
    static constexpr std::string_view kSurfacePrefix = "surface:", kFieldPrefix = "field:";

    std::optional<Of> of;  ///< Whose array it is; none: the field's, or else the surface's.
    std::string name;      ///< NAME or NAME:mag, or empty: no colours.

    bool mayBeOfSurface() const { return of != Of::field; }
    bool mayBeOfField() const { return of != Of::surface; }
};

inline ColorBy parseColorBy(const std::string& text)
{
    if (text.starts_with(ColorBy::kSurfacePrefix))
        return {ColorBy::Of::surface, text.substr(ColorBy::kSurfacePrefix.size())};
    if (text.starts_with(ColorBy::kFieldPrefix)) return {ColorBy::Of::field, text.substr(ColorBy::kFieldPrefix.size())};
    return {std::nullopt, text};
}

}  // namespace aeolic
