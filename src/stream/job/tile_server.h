#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "stream/listen.h"
#include "stream/message.h"

namespace aeolic::stream {

struct TileLimits {
    std::chrono::milliseconds invitationTime{30000};  ///< An invitation is good for so long.
    std::uint64_t bytes = std::uint64_t(-1);          ///< All tiles that wait for viewers, together.
};

/// A rank's own port for viewers (paper, section 4: every node sends its stripe to the viewer itself). An invited
/// viewer opens a WebSocket with its token, once. Tiles then go to it without a detour. The server has its own thread,
/// and any thread may call any method.
class TileServer {
public:
    /// Listens on a free one of these ports: of all interfaces, or of loopback alone. Throws std::runtime_error.
    explicit TileServer(bool everywhere, PortRange ports = {}, const TileLimits& limits = {});
    ~TileServer();

    std::uint16_t port() const;
    /// Lets the client in that brings `token` within the time for invitations.
    void invite(std::uint32_t viewer, const std::string& token);
    /// Invitations that were not taken and have not run out.
    std::size_t invitations() const;
    /// Whether the tile is on its way. False where the viewer is not connected, or has left two other frames unread, or
    /// where all tiles that wait would take more than they may.
    bool send(std::uint32_t viewer, const WireMessage& tile);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic::stream
