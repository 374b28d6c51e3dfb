#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace aeolic {

/// 256 sRGB colours; entry 0 shows the low end of the range, entry 255 the high end.
using ColorTable = std::array<std::array<std::uint8_t, 3>, 256>;

/// The table of that name. Valid for the program's lifetime. Throws InputError with the names that there are.
const ColorTable& colorMap(std::string_view name);

/// The names colorMap() knows, the default first. Valid for the program's lifetime.
std::span<const std::string_view> colorMapNames();

}  // namespace aeolic
