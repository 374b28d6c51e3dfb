#include "stream/gateway/restarts.h"

#include <fmt/format.h>

#include <algorithm>

namespace aeolic::stream {

void Restarts::ended(bool wasOfUse, Time now)
{
    inARow_ = wasOfUse ? 0 : inARow_ + 1;
    ends_.push_back(now);
    while (now - ends_.front() >= kWindow) ends_.pop_front();
}

std::optional<std::string> Restarts::hopeless() const
{
    if (inARow_ >= kMostInARow) return fmt::format("given up after {} starts without a picture", inARow_);
    if (ends_.size() >= kMostAtOnce)
        return fmt::format("given up after {} starts within {} minutes", ends_.size(), kWindow.count());
    return std::nullopt;
}

std::chrono::milliseconds Restarts::pause() const
{
    return std::chrono::milliseconds(inARow_ == 0 ? 0 : 250 << std::min(inARow_ - 1, 5));
}

void Restarts::onceMore()
{
    inARow_ = std::min(inARow_, kMostInARow - 1);
    ends_.clear();
}

}  // namespace aeolic::stream
