#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace aeolic {

/// How many there are by a file's own account: a polygon is one triangle or more, and points may be left out that none
/// uses.
struct SurfaceCounts {
    std::uint64_t points = 0;  ///< 0: not told.
    std::uint64_t polygons = 0;
};

/// Of a surface from its file's header (.vtp, .ply, .stl with bytes); nothing for other files. Throws InputError for a
/// file that cannot be read.
std::optional<SurfaceCounts> surfaceCountsOf(const std::string& path);

}  // namespace aeolic
