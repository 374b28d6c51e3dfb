#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace aeolic {

/// An sRGB colour.
using Color = std::array<std::uint8_t, 3>;

/// 256 colours; entry 0 shows the low end of the range, entry 255 the high end.
using ColorTable = std::array<Color, 256>;

/// A colour map, with the colours that its file has for values outside of the range.
struct ColorMap {
    ColorTable colors{};
    std::optional<Color> nan, below, above;
};

/// The table of that name. Valid for the program's lifetime. Throws InputError with the names that there are.
const ColorTable& colorMap(std::string_view name);

/// The names colorMap() knows, the default first. Valid for the program's lifetime.
std::span<const std::string_view> colorMapNames();

/// Whether that is the name of a file that may hold a colour map: it ends in .json, .xml or .csv.
bool isColorMapFile(std::string_view name);

/// The colour of six hexadecimal digits.
Color colorOf(std::string_view rrggbb);

}  // namespace aeolic
