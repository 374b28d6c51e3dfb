#pragma once

#include <memory>
#include <optional>

#include "stream/gateway/hub/hub.h"
#include "stream/outgoing.h"
#include "stream/web_connection.h"

namespace aeolic::stream {

/// One viewer's WebSocket: what it says goes to the hub, what the hub says goes out in order.
class ViewerSession final : public ViewerPort, public std::enable_shared_from_this<ViewerSession> {
public:
    ViewerSession(WebConnection connection, Hub& hub, std::shared_ptr<CommonRate> common);

    void send(WireMessage message) override;
    int framesQueued() const override { return queue_.frames(); }
    std::optional<std::uint32_t> oldestQueued() const override { return queue_.oldestFrame(); }
    bool isOpen() const override { return !closing_; }
    void close(std::uint16_t code, const std::string& reason) override;

    /// Opens the WebSocket that `request` asks for. Lasts until the viewer leaves or is sent away.
    asio::awaitable<void> run(HttpRequest request);

private:
    asio::awaitable<void> readAll();
    asio::awaitable<void> waitForTurn();
    void take(ByteView bytes);
    void greet(const MessageView& message);
    void fail(const std::exception& error);
    asio::awaitable<void> writeQueue();
    static asio::awaitable<void> writeAll(std::shared_ptr<ViewerSession> self);
    static asio::awaitable<void> watchWrites(std::shared_ptr<ViewerSession> self);

    struct Closing {
        std::uint16_t code;
        std::string reason;
        SteadyClock::time_point since;
    };

    WebConnection connection_;
    Hub& hub_;
    asio::steady_timer wake_;
    Outgoing queue_;
    std::optional<Closing> closing_;
    bool readerEnded_ = false, writerEnded_ = false;
    std::optional<SteadyClock::time_point> writing_;  ///< Since when a message is being written.
    std::optional<Seat> seat_;                        ///< From the viewer's Hello on.
    Allowance rate_{kMessagesAtOnce, kMessagesPerSecond};
    std::shared_ptr<CommonRate> common_;
};

}  // namespace aeolic::stream
