#pragma once

#include <string>

#include "stream/link/link_socket.h"
#include "stream/requests.h"

namespace aeolic::stream {

// How a link begins (docs/protocol.md, "Between gateway and job"). Both ends show that they know the secret of this
// start; it is never sent. The gateway shows it first, so that a rank tells nothing about itself to anybody else.

/// The gateway's part. Returns what the rank says about itself. Throws where it does not know the secret.
asio::awaitable<Json> greetRank(LinkSocket& link, std::string secret);

/// A rank's part. `about` is what it says about itself. Throws where the other end does not know the secret.
asio::awaitable<void> greetGateway(LinkSocket& link, std::string secret, Json about);

}  // namespace aeolic::stream
