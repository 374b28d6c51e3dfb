#pragma once

#include "base/busy_clock.h"
#include "cluster/communicator.h"
#include "cluster/stripes.h"
#include "render/tile.h"

namespace aeolic {

/// Collective, on ranks other than 0: sends the rows of `stripe` from the first to the last that are painted, in place,
/// and 12 bytes to say which. Background above and below stays where it is.
void sendPainted(Communicator& communicator, const Tile& stripe);

/// Collective, on rank 0, in whose `picture` its own rows are: all others become what their ranks send, or background.
/// `busy` is stopped when called, and runs while rank 0 works.
void receivePainted(Communicator& communicator, const Stripes& stripes, Tile& picture, BusyClock& busy);

}  // namespace aeolic
