#pragma once

#include <deque>
#include <map>

#include "stream/message.h"

namespace aeolic::stream {

/// What is on its way to one viewer, in order, and of how many frames that is: a viewer may say that it has shown what
/// it never read, but not what is still here. Not thread-safe.
class Outgoing {
public:
    void push(WireMessage message);
    bool empty() const { return messages_.empty(); }
    const WireMessage& front() const { return messages_.front(); }
    /// The front one is in the socket, and leaves.
    void pop();

    /// Of which something is here.
    int frames() const { return int(messagesOfFrame_.size()); }
    bool has(std::uint32_t frame) const { return messagesOfFrame_.count(frame) > 0; }
    /// Bytes of the messages here that belong to no frame.
    std::size_t otherBytes() const { return otherBytes_; }

private:
    std::deque<WireMessage> messages_;
    std::map<std::uint32_t, int> messagesOfFrame_;
    std::size_t otherBytes_ = 0;
};

}  // namespace aeolic::stream
