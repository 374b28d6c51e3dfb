#pragma once

#include <array>
#include <optional>

#include "data/load/agreement.h"
#include "data/scene.h"

namespace aeolic {

/// The 2nd and the 98th percentile of what `scene` is coloured by, by the surface's area; nothing where no value is
/// finite. Areas are whole numbers, so any number of threads and ranks finds the same bits. A field is taken in the
/// middles of triangles, of large ones at points about a cell apart. `shared`: Collective, and each rank has a part;
/// null: Local. Cost: three passes over the triangles.
std::optional<std::array<double, 2>> robustRangeOf(const Scene& scene, Agreement* shared);

}  // namespace aeolic
