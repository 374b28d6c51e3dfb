#pragma once

#include <cstdint>

namespace aeolic::stream {

/// The codes of RFC 6455 that a server closes a WebSocket with.
struct Goodbye {
    static constexpr std::uint16_t goingAway = 1001, protocolError = 1002, policyError = 1008, tooBig = 1009,
                                   internalError = 1011, tryAgainLater = 1013;
};

}  // namespace aeolic::stream
