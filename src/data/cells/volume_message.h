#pragma once

#include <span>

#include "base/uninitialized.h"
#include "data/cells/volume_cells.h"

namespace aeolic {

/// Cells as a message to other ranks, without their name.
Bytes messageOf(const VolumeCells& cells);

/// Appends a message's cells, their points numbered after those there. Throws std::runtime_error for one that is
/// malformed.
void appendCells(std::span<const std::byte> message, VolumeCells& cells);

}  // namespace aeolic
