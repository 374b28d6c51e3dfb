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

/// Collective. Sort-last composition (bachthaler2006parallel, section 6) by direct send: every rank sends each other
/// one its brick's pixels in that rank's rows, and overwrites its own with theirs. No depth is compared: all draw
/// the same surface, and each pixel's cell is one rank's alone.
///
/// `rowsOf`: the rows that each rank needs, global pixels. `share.into` holds no flow in this rank's rows yet. A
/// message is, for each row that `share.mine` meets: the number of runs (16 bits), the runs' first and last + 1 column
/// (16 bits each), then 4 bytes of flow for each pixel, and 4 of scalar.
void composite(Communicator& communicator, const BrickShare& share, const std::vector<Extent>& rowsOf);

}  // namespace aeolic
