#pragma once

#include <string>
#include <string_view>

namespace aeolic::stream {

/// The two ends of a job's link. Each proves another thing, so that nobody can send a proof back.
enum class LinkEnd { gateway, rank };

/// Shows that an end knows the secret of this start, which itself is never sent: HMAC-SHA256 over the end, what both
/// ends have drawn at random (makeToken()) for this one link, and `claim`, in hexadecimal digits.
std::string linkProof(std::string_view secret, LinkEnd end, std::string_view gatewayNonce, std::string_view rankNonce,
                      std::string_view claim = {});

/// Whether a text can be what the other end has drawn at random.
bool isNonce(std::string_view text);

}  // namespace aeolic::stream
