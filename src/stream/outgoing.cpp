#include "stream/outgoing.h"

namespace aeolic::stream {

void Outgoing::push(WireMessage message)
{
    if (const auto frame = frameOf(*message))
        ++messagesOfFrame_[*frame];
    else
        otherBytes_ += message->size();
    messages_.push_back(std::move(message));
}

void Outgoing::pop()
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

}  // namespace aeolic::stream
