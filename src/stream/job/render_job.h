#pragma once

#include <iosfwd>
#include <memory>

namespace aeolic {
class Communicator;
}

namespace aeolic::stream {

/// Collective. The render job of a server: reads the gateway's address from `addressLine` (on rank 0 alone), then loads
/// and draws what the gateway asks for until it says Quit. Every rank has its own link to the gateway, so requests
/// reach all in the same order and no rank waits for them in MPI, where waiting costs a core. Throws where the gateway
/// cannot be reached.
void runRenderJob(const std::shared_ptr<Communicator>& ranks, std::istream& addressLine);

}  // namespace aeolic::stream
