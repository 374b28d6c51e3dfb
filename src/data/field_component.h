#pragma once

#include <memory>

#include "data/vector_field.h"

namespace aeolic {

/// A component of vectors on a grid, as a scalar on the same grid. `vectors`: floats that do not lie in tiles. Throws
/// InputError where there is no memory for it. Parallel.
std::shared_ptr<const GridField> componentOf(const GridField& vectors, int component);

}  // namespace aeolic
