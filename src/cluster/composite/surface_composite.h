#pragma once

#include <vector>

#include "cluster/comm/communicator.h"
#include "render/share.h"

namespace aeolic {

/// Collective. Composition by depth, by direct send, where ranks hold different pieces of the surface: every rank sends
/// each other one what it sees of its own piece in that rank's rows, and keeps the nearest pixels. Each pixel is
/// one piece's alone, whole: nothing is blended, so the order of messages does not matter, nor how many there are. A
/// triangle that several ranks hold (cluster/composite/deal_triangles.h) is known by its order: what comes from the
/// field is then that rank's which has something.
///
/// `rowsOf`: the rows that each rank needs, global pixels. `share.into` holds background in this rank's rows; its
/// scalar is filled in if it has the flow's extent, on all ranks or none. A message is: first and last + 1 row (32 bits
/// each); then for each row the number of runs (16 bits), the runs' first and last + 1 column (16 bits each), and, run
/// after run, of each pixel 4 bytes of depth, 8 of order, and 4 each of 1 / eye depth, its change to the right and
/// down, light, flow, and scalar: 32 or 36 bytes a pixel. Throws std::runtime_error naming the sender of any other
/// message.
void composite(Communicator& communicator, const PieceShare& share, const std::vector<Extent>& rowsOf);

}  // namespace aeolic
