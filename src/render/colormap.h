#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// 256 sRGB colours; entry 0 shows the low end of the range, entry 255 the high end.
using ColorTable = std::array<std::array<std::uint8_t, 3>, 256>;

/// The table of that name. Valid for the program's lifetime. Throws InputError listing the names there are.
const ColorTable& colorMap(std::string_view name);

/// The names colorMap() knows, the default first.
std::vector<std::string> colorMapNames();

}  // namespace aeolic
