#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/load/agreement.h"
#include "data/scene.h"

namespace aeolic {

/// Why a part of a surface has no streaks. Areas are whole numbers, so sums over ranks have the same bits.
struct BlankAreas {
    std::int64_t all = 0;
    std::int64_t outside = 0;  ///< The field is elsewhere.
    std::int64_t masked = 0;   ///< Values are masked or not finite.
    std::int64_t still = 0;    ///< The vector is zero.
    std::int64_t across = 0;   ///< The vector is along the normal.
};

/// What this rank's triangles have at their middles. `withinField`: [points] which of them a field has that was looked
/// up in its own cells; empty where there is none. Where a surface is whole on all ranks and the field is in bricks,
/// each rank counts what is in its own brick, and rank 0 what is outside. Cost: one parallel pass over the triangles.
BlankAreas blankAreasOf(const Scene& scene, const std::vector<char>& withinField, bool countsOutside);

/// One line where more than half of the surface has no streaks: why that is for most of it, and what to try. Else
/// empty.
std::string blankWarning(const std::string& surface, const BlankAreas& areas, const Scene& scene, bool hasField);

}  // namespace aeolic
