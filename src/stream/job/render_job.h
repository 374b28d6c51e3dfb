#pragma once

#include <iosfwd>
#include <memory>

namespace aeolic {
class Communicator;
}

namespace aeolic::stream {

/// Collective. The render job of a server: takes where the gateway is from `addressLine` (rank 0's; others' is not
/// read), then loads and draws what the gateway asks for until it says Quit. Every rank has its own link to the
/// gateway: requests come to all in the same order, and nobody waits for one in MPI, where waiting costs a core. Throws
/// where the gateway cannot be reached.
void runRenderJob(const std::shared_ptr<Communicator>& ranks, std::istream& addressLine);

}  // namespace aeolic::stream
