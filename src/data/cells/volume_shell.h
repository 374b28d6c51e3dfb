#pragma once

#include <span>

#include "base/uninitialized.h"
#include "data/cells/near_surface.h"
#include "data/cells/volume_cells.h"

namespace aeolic {

/// The cells of a volume that are near a surface, with their points alone: all that a CellSampler can find at places
/// within the surface's reach. A cell is near where its middle is no farther from a triangle than the triangle's reach
/// and the cell's own diagonal. In the order of the volume. Cost: one parallel pass over the cells.
VolumeCells shellOf(const VolumeCells& cells, const NearSurface& surface);

/// Cells as a message to other ranks, without their name.
Bytes messageOf(const VolumeCells& cells);

/// Appends a message's cells, their points numbered after those there. Throws std::runtime_error for one that is
/// malformed.
void appendCells(std::span<const std::byte> message, VolumeCells& cells);

}  // namespace aeolic
