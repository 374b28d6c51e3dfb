#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "aeolic/surface_spec.h"
#include "base/bounds.h"

namespace aeolic {

/// What a cut has to know of all of a data set, which may lie in pieces. Each piece tells its own.
struct CutOutline {
    Bounds boundsWorld;
    // Only an isosurface has these.
    std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};  ///< Of the array's finite values.
    std::uint64_t crossed = 0;  ///< How many cells have points on both sides of the value.

    void add(const CutOutline& other);
};

/// Throws InputError where nothing can be cut, or where ranks of a host that cut at once have no memory for it. It
/// begins with `where`, the file's name, and names the range or the bounds.
void requireCut(const CutOutline& all, const SurfaceSpec& spec, const std::string& where, int ranksOnHost);

/// Throws the same unless so many polygons were cut out.
void requirePolygons(std::size_t polygons, const CutOutline& all, const SurfaceSpec& spec, const std::string& where);

}  // namespace aeolic
