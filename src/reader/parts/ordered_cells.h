#pragma once

#include <cstdint>
#include <span>

#include "reader/parts/part_source.h"

namespace aeolic {

/// The cells between points in rows, as many in each direction as `lengths` says, the first direction fastest:
/// hexahedra or, where points go in two directions alone, quads. None where they go in fewer.
PartCells orderedCells(std::span<const std::int64_t> lengths);

}  // namespace aeolic
