#pragma once

#include <algorithm>
#include <chrono>

namespace aeolic::stream {

/// Limits a viewer's messages to so many a second, with some to spare: a network may hold messages up and let them go
/// at once.
class RequestRate {
public:
    /// Counts one more message. Returns false if that is too many.
    bool allows(std::chrono::steady_clock::time_point now)
    {
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        left_ = std::min(kBurst, left_ + seconds * kPerSecond) - 1;
        return left_ >= 0;
    }

    static constexpr double kPerSecond = 300;  ///< 120 views, as many acknowledgements, and some more.
    static constexpr double kBurst = 600;

private:
    double left_ = kBurst;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace aeolic::stream
