#pragma once

#include <vector>

#include "cluster/comm/communicator.h"
#include "render/share.h"

namespace aeolic {

/// Collective. Sort-last composition (bachthaler2006parallel, section 6) by direct send: every rank sends each other
/// one its brick's pixels in that rank's rows, and overwrites its own with theirs. No depth is compared: all draw
/// the same surface, and each pixel's cell is one rank's alone.
///
/// `rowsOf`: the rows that each rank needs, global pixels. `share.into` holds no flow in this rank's rows yet. A
/// message is, for each row that `share.mine` meets: the number of runs (16 bits), the runs' first and last + 1 column
/// (16 bits each), then 4 bytes of flow for each pixel, and 4 of scalar.
void composite(Communicator& communicator, const BrickShare& share, const std::vector<Extent>& rowsOf);

}  // namespace aeolic
