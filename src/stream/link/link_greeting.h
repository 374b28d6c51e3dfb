#pragma once

#include <string>
#include <string_view>

#include "stream/link/link_socket.h"
#include "stream/requests.h"

namespace aeolic::stream {

// How a link begins (docs/protocol.md, "Between gateway and job"). Both ends show that they know the secret of this
// start; it is never sent. The gateway shows it first, so that a rank tells nothing about itself to anybody else.

/// The two ends of a job's link. Each proves another thing, so that nobody can send a proof back.
enum class LinkEnd { gateway, rank };

/// Shows that an end knows the secret of this start, which itself is never sent: HMAC-SHA256 over the end, what both
/// ends have drawn at random (makeToken()) for this one link, and `claim`, in hexadecimal digits.
std::string linkProof(std::string_view secret, LinkEnd end, std::string_view gatewayNonce, std::string_view rankNonce,
                      std::string_view claim = {});

/// Whether a text can be what the other end has drawn at random.
bool isNonce(std::string_view text);

/// The gateway's part. Returns what the rank says about itself. Throws where it does not know the secret.
asio::awaitable<Json> greetRank(LinkSocket& link, std::string secret);

/// A rank's part. `about` is what it says about itself. Throws where the other end does not know the secret.
asio::awaitable<void> greetGateway(LinkSocket& link, std::string secret, Json about);

}  // namespace aeolic::stream
