#pragma once

#include <chrono>
#include <memory>

#include "stream/client/stream_address.h"
#include "stream/message.h"

namespace aeolic::stream {

/// The client's side of a WebSocket, plain or TLS. Calls wait at most `timeout`. A call that has waited in vain drops
/// the connection. Throws std::runtime_error with one line.
class ClientWebSocket {
public:
    virtual ~ClientWebSocket() = default;
    virtual void send(const WireMessage& message, std::chrono::milliseconds timeout) = 0;
    virtual ByteVector receive(std::chrono::milliseconds timeout) = 0;
};

std::unique_ptr<ClientWebSocket> openWebSocket(const StreamAddress& address, bool trustAnyCertificate,
                                               std::chrono::milliseconds timeout);

}  // namespace aeolic::stream
