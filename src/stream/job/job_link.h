#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "stream/gateway_address.h"
#include "stream/message.h"
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
    ~JobLink();

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
    struct Socket;
    void readAll();
    void writeAll();
    void answerPing();
    bool waitForWork(std::unique_lock<std::mutex>& lock);
    void end();

    std::unique_ptr<Socket> socket_;
    std::function<void()> onEnd_;
    std::function<void(const MessageView&)> onInvite_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<WireMessage> received_, toSend_;
    std::size_t queuedBytes_ = 0;
    bool closing_ = false, ended_ = false, pongQueued_ = false;
    const std::chrono::seconds silenceLimit_;
    std::chrono::steady_clock::time_point heard_ = std::chrono::steady_clock::now();
    std::thread reader_, writer_;
};

}  // namespace aeolic::stream
