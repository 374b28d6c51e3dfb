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

/// A rank's connection to the gateway. Messages come in the order they were sent; what is sent goes out beside what
/// the rank does. When the gateway has gone, `onEnd` is called on a thread of the link's: others may wait for this rank
/// in a collective call, so all there is to do is to end the process.
class JobLink {
public:
    /// Connects, and sends `join`. Throws std::runtime_error where no host answers.
    /// `onInvite` gets Invite messages as they come, on the link's thread, whatever the rank is doing.
    JobLink(const GatewayAddress& address, const WireMessage& join, std::function<void()> onEnd,
            std::function<void(const MessageView&)> onInvite = {});
    ~JobLink();

    /// Waits for the next message.
    WireMessage receive();
    /// Whether one is there that is of this type.
    bool isNext(MessageType type);
    /// Waits while more is queued than a few frames take.
    void send(WireMessage message);
    /// Waits until all that was sent is out, and hangs up without `onEnd`.
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
