#pragma once

#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Local. Rank 0 of 1: what a single process uses, so that the frame needs no special case.
std::unique_ptr<Communicator> makeSerialCommunicator();

}  // namespace aeolic
