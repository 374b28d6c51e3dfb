#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "stream/message.h"

namespace aeolic::stream {

/// A rank's own port for viewers (paper, section 4: every node sends its stripe to the viewer itself). A viewer that
/// was invited opens a WebSocket with its token, once; tiles then go to it without a detour. Has a thread of its own;
/// every method may be called from any thread.
class TileServer {
public:
    /// Listens on a free port: of all interfaces, or of loopback alone. Throws std::runtime_error.
    explicit TileServer(bool everywhere);
    ~TileServer();

    std::uint16_t port() const;
    /// Lets the one in who brings `token` within the next 30 seconds.
    void invite(std::uint32_t viewer, const std::string& token);
    /// Whether the tile is on its way: false where no connection of that viewer stands, or it has left two other frames
    /// unread.
    bool send(std::uint32_t viewer, const WireMessage& tile);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic::stream
