#pragma once

#include <cstdint>

#include "base/busy_clock.h"
#include "cluster/communicator.h"
#include "cluster/stripes.h"
#include "render/tile.h"

namespace aeolic {

/// What says which rows of a stripe are painted.
inline constexpr std::int64_t kPaintedRowsBytes = 12;

/// Collective, on ranks other than 0: sends the rows of `stripe` from the first to the last that are painted, in place,
/// and kPaintedRowsBytes to say which. Background above and below stays where it is.
void sendPainted(Communicator& communicator, const Tile& stripe);

/// Collective, on rank 0, in whose `picture` its own rows are: all others become what their ranks send, or background.
/// `busy` is stopped when called, and runs while rank 0 works.
void receivePainted(Communicator& communicator, const Stripes& stripes, Tile& picture, BusyClock& busy);

}  // namespace aeolic
