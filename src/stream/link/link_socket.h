#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "stream/asio.h"
#include "stream/link/link_tls.h"
#include "stream/message.h"

namespace aeolic::stream {

/// A connection between the gateway and a rank, plain or TLS. Everything throws std::exception when it ends.
class LinkSocket {
public:
    explicit LinkSocket(Tcp::socket socket) : socket_(std::move(socket)) {}

    Tcp::socket& tcp() { return socket_; }
    /// When the last bytes came that read() waited for. A large message takes long: every part of it counts.
    std::chrono::steady_clock::time_point heard() const { return heard_; }
    void heardAt(std::chrono::steady_clock::time_point when) { heard_ = when; }
    void close();

    // Only the thread of the socket's io_context may call these. One read and one write may be pending at a time.
    asio::awaitable<void> startTls(TlsSide side, bool isServer);
    asio::awaitable<void> read(std::uint8_t* to, std::size_t count);
    asio::awaitable<void> write(ByteView bytes);
    /// The next message; where `type` is given it has to be of this type.
    asio::awaitable<WireMessage> readMessage(Sender sender, std::optional<MessageType> type = std::nullopt);

private:
    Tcp::socket socket_;
    std::unique_ptr<LinkTls> tls_;
    std::chrono::steady_clock::time_point heard_ = std::chrono::steady_clock::now();
    ByteVector wire_ = ByteVector(std::size_t{1} << 16);  ///< Bytes that have come and are not unpacked yet.
};

}  // namespace aeolic::stream
