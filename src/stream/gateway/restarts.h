#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>
#include <string>

namespace aeolic::stream {

/// Says when a job that has ended is started again, and when not any more. Knows no clock.
class Restarts {
public:
    using Time = std::chrono::steady_clock::time_point;

    static constexpr int kMostInARow = 6;            ///< Starts without a picture.
    static constexpr std::size_t kMostAtOnce = 100;  ///< Starts within kWindow, whether of use or not.
    static constexpr auto kWindow = std::chrono::minutes(10);

    /// The job has ended. `wasOfUse`: it has drawn a picture.
    void ended(bool wasOfUse, Time now)
    {
        inARow_ = wasOfUse ? 0 : inARow_ + 1;
        ends_.push_back(now);
        while (now - ends_.front() >= kWindow) ends_.pop_front();
    }

    /// Why it is not started again, if it is not.
    std::optional<std::string> hopeless() const
    {
        if (inARow_ >= kMostInARow) return fmt::format("given up after {} starts without a picture", inARow_);
        if (ends_.size() >= kMostAtOnce)
            return fmt::format("given up after {} starts within {} minutes", ends_.size(), kWindow.count());
        return std::nullopt;
    }

    /// How long to wait before the next start: ¼ to 8 seconds, and nothing after a job that was of use.
    std::chrono::milliseconds pause() const
    {
        return std::chrono::milliseconds(inARow_ == 0 ? 0 : 250 << std::min(inARow_ - 1, 5));
    }

    /// Somebody asked for another start: there is one, and more if it is of use.
    void onceMore()
    {
        inARow_ = std::min(inARow_, kMostInARow - 1);
        ends_.clear();
    }

private:
    int inARow_ = 0;
    std::deque<Time> ends_;  ///< Within the window.
};

}  // namespace aeolic::stream
