#pragma once

#include "cluster/communicator.h"

namespace aeolic {

/// Collective. How many ranks, this one included, run on this rank's host.
int ranksOnThisHost(Communicator& communicator);

}  // namespace aeolic
