#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "stream/message.h"

namespace aeolic::stream {

/// A rank's own port for viewers (paper, section 4: every node sends its stripe to the viewer itself). An invited
/// viewer opens a WebSocket with its token, once. Tiles then go to it without a detour. The server has its own thread,
/// and any thread may call any method.
class TileServer {
public:
    /// Listens on a free port: of all interfaces, or of loopback alone. Throws std::runtime_error.
    explicit TileServer(bool everywhere);
    ~TileServer();

    std::uint16_t port() const;
    /// Lets the client in that brings `token` within the next 30 seconds.
    void invite(std::uint32_t viewer, const std::string& token);
    /// Whether the tile is on its way. False where the viewer is not connected, or has left two other frames
    /// unread.
    bool send(std::uint32_t viewer, const WireMessage& tile);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic::stream
