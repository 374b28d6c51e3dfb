#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/load/agreement.h"
#include "data/scene.h"

namespace aeolic {

/// Why a part of a surface has no streaks. Areas are whole numbers, so sums over ranks have the same bits.
struct BlankAreas {
    std::int64_t within = 0;  ///< What the field has, with streaks or without. The rest is outside of it.
    std::int64_t masked = 0;  ///< Values are masked or not finite.
    std::int64_t still = 0;   ///< The vector is zero.
    std::int64_t across = 0;  ///< The vector is along the normal.
};

/// The area of this rank's triangles, in the unit of BlankAreas.
std::int64_t areaOf(const Scene& scene);

/// What this rank's triangles have at their middles, as far as those are in its part of the field. `withinField`:
/// [points] which of them a field has that was looked up in its own cells; empty where there is none. Cost: one
/// parallel pass over the triangles.
BlankAreas blankAreasOf(const Scene& scene, const std::vector<char>& withinField);

/// Collective. The same of all ranks together. Every triangle's middle is in one rank's brick.
BlankAreas blankAreasOf(const Scene& scene, const std::vector<char>& withinField, Agreement& agreement);

/// Where a surface's vectors are from: its own, or a field, at an offset that the user gave or not.
enum class VectorsFrom { surface, field, fieldAtOffset };

/// One line where more than half of the surface, whose area is `all`, has no streaks: why that is for most of it, and
/// what to try. Else empty.
std::string blankWarning(const std::string& surface, const BlankAreas& areas, std::int64_t all, VectorsFrom from);

}  // namespace aeolic
