#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "stream/gateway_address.h"
#include "stream/message.h"

namespace aeolic::stream {

/// A rank's connection to the gateway. Messages come in the order they were sent. They go out on a thread of the link,
/// while the rank works. When the gateway has gone, a thread of the link calls `onEnd`, which should end the process:
/// other ranks may wait for this one in a collective call.
class JobLink {
public:
    /// Connects, and sends `join`. Throws std::runtime_error where no host answers.
    /// `onInvite` gets Invite messages as they come, on the link's thread, whatever the rank is doing.
    JobLink(const GatewayAddress& address, const WireMessage& join, std::function<void()> onEnd,
            std::function<void(const MessageView&)> onInvite = {});
    ~JobLink();

    /// Waits for the next message.
    WireMessage receive();
    /// Whether the next message is there and has this type.
    bool isNext(MessageType type);
    /// Waits while the queue holds more than a few frames.
    void send(WireMessage message);
    /// Waits until the queue is sent, and hangs up without calling `onEnd`.
    void close();

private:
    struct Socket;
    void readAll();
    void writeAll();

    std::unique_ptr<Socket> socket_;
    std::function<void()> onEnd_;
    std::function<void(const MessageView&)> onInvite_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<WireMessage> received_, toSend_;
    std::size_t queuedBytes_ = 0;
    bool closing_ = false;
    std::thread reader_, writer_;
};

}  // namespace aeolic::stream
