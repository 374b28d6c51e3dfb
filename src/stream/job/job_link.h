#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "stream/gateway_address.h"
#include "stream/link/link_socket.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// A rank's connection to the gateway. Messages arrive in the order they were sent. Sending goes on while the rank does
/// something else, and so does answering the gateway's pings. When the gateway has gone, or has not said anything for
/// its silence limit, `onEnd` is called on a thread of the link. Other ranks may wait for this one in a collective call
/// then, so a process that only draws ends itself.
class JobLink {
public:
    /// Connects, and tells the gateway `about` this rank (docs/protocol.md, Join) once it has shown that it knows the
    /// secret. Throws std::runtime_error where no such host answers. `onInvite` is called on the link's thread for each
    /// Invite message, whatever the rank is doing.
    JobLink(const GatewayAddress& address, const Json& about, std::function<void()> onEnd,
            std::function<void(const MessageView&)> onInvite = {});
    ~JobLink() { close(); }

    /// Waits for the next message. Throws std::runtime_error where none will come, because the link has ended.
    WireMessage receive();
    /// How many messages are here. Where there are fewer than `enough`, waits so long for them.
    std::size_t waiting(std::chrono::milliseconds time, std::size_t enough);
    bool hasEnded();
    /// Whether a message is there, and is of this type.
    bool isNext(MessageType type);
    /// Waits while the messages of more than a few frames are queued.
    void send(WireMessage message);
    /// Waits until the queue is sent, and hangs up without calling `onEnd`.
    void close();

private:
    void meet(const GatewayAddress& address, const Json& about);
    void meetAt(const std::string& host, const GatewayAddress& address, const TlsSide& tls, const Json& about);
    asio::awaitable<void> greet(Tcp::resolver::results_type places, TlsSide tls, std::string secret, Json about);
    asio::awaitable<void> readAll();
    bool take(WireMessage message);
    asio::awaitable<void> writeAll();
    asio::awaitable<void> writeQueue();
    void queue(WireMessage message);
    void end();

    std::function<void()> onEnd_;
    std::function<void(const MessageView&)> onInvite_;
    const std::chrono::seconds silenceLimit_;

    // Once the link's thread runs, it alone uses what follows.
    asio::io_context io_{1};
    LinkSocket link_{Tcp::socket(io_)};
    asio::steady_timer wake_{io_};  ///< Cancelled when there is something to write.
    std::chrono::steady_clock::time_point heard_;
    bool pongQueued_ = false;

    std::mutex mutex_;  ///< Guards all down to `writerEnded_`.
    std::condition_variable changed_;
    std::deque<WireMessage> received_, toSend_;
    std::size_t queuedBytes_ = 0;
    bool closing_ = false, ended_ = false, writerEnded_ = false;

    std::thread thread_;
};

}  // namespace aeolic::stream
