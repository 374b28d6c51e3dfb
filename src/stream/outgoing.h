#pragma once

#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "stream/message.h"

namespace aeolic::stream {

/// The messages on their way to one viewer, in order, and to how many frames they belong. A viewer may claim to have
/// shown a frame that it never read. It cannot have read frames that are still here. Not thread-safe.
class Outgoing {
public:
    void push(WireMessage message)
    {
        if (const auto frame = frameOf(*message))
            ++messagesOfFrame_[*frame];
        else
            otherBytes_ += message->size();
        messages_.push_back(std::move(message));
    }
    bool empty() const { return messages_.empty(); }
    const WireMessage& front() const { return messages_.front(); }
    /// Removes the first message: it is in the socket.
    void pop()
    {
        const WireMessage message = std::move(messages_.front());
        messages_.pop_front();
        if (const auto frame = frameOf(*message)) {
            const auto left = messagesOfFrame_.find(*frame);
            if (--left->second == 0) messagesOfFrame_.erase(left);
        } else {
            otherBytes_ -= message->size();
        }
    }

    /// How many frames have messages here.
    int frames() const { return int(messagesOfFrame_.size()); }
    bool has(std::uint32_t frame) const { return messagesOfFrame_.count(frame) > 0; }
    /// The oldest frame that has messages here.
    std::optional<std::uint32_t> oldestFrame() const
    {
        return messagesOfFrame_.empty() ? std::nullopt : std::optional(messagesOfFrame_.begin()->first);
    }
    /// Bytes of the messages here that belong to no frame.
    std::size_t otherBytes() const { return otherBytes_; }

private:
    std::deque<WireMessage> messages_;
    std::map<std::uint32_t, int> messagesOfFrame_;
    std::size_t otherBytes_ = 0;
};

}  // namespace aeolic::stream
