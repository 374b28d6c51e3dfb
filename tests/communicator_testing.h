#pragma once

#include <string>
#include <vector>

#include "cluster/comm/communicator.h"

namespace aeolic::testkit {

/// Collective. Every operation of a communicator with answers that are known for any number of ranks. Returns what was
/// wrong, a line each; empty: all is well. Uses no test framework, because it also runs under mpirun without one.
std::vector<std::string> communicatorFaults(Communicator& communicator);

/// `count` bytes that differ for every `seed`.
Bytes patternBytes(std::size_t count, int seed);

}  // namespace aeolic::testkit
