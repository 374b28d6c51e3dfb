#pragma once

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
    void ended(bool wasOfUse, Time now);

    /// Why it is not started again, if it is not.
    std::optional<std::string> hopeless() const;

    /// How long to wait before the next start: ¼ to 8 seconds, and nothing after a job that was of use.
    std::chrono::milliseconds pause() const;

    /// Somebody asked for another start: there is one, and more if it is of use.
    void onceMore();

private:
    int inARow_ = 0;
    std::deque<Time> ends_;  ///< Within the window.
};

}  // namespace aeolic::stream
