#pragma once

#include <functional>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// Runs `body` once for each of `ranks` ranks, every rank a thread of this process, and returns when all are done.
/// Tests of whatever is collective use it, and measurements of how it scales: both without MPI.
///
/// A mistake that would hang a real job is an error here: ranks in different operations, a rank that left while another
/// waits for it, ranks that all wait, a message that nobody took, or of another length than announced
/// (std::logic_error). When one rank throws, the others are released from their operations, and the first error is
/// thrown again from here.
void runRanks(int ranks, const std::function<void(Communicator&)>& body);

}  // namespace aeolic
