#pragma once

#include <algorithm>
#include <chrono>

namespace aeolic::stream {

/// How many messages a viewer may send: 120 views a second, as many acknowledgements, and some more. A network may hold
/// messages up for two seconds and let them go together.
inline constexpr double kMessagesAtOnce = 600, kMessagesPerSecond = 300;

/// So many at once, and after that so many a second.
class Allowance {
public:
    using Time = std::chrono::steady_clock::time_point;

    Allowance(double atOnce, double perSecond) : atOnce_(atOnce), perSecond_(perSecond), left_(atOnce) {}

    /// Takes one of those that are allowed. False where none is left.
    bool take(Time now)
    {
        const double seconds = std::max(0.0, std::chrono::duration<double>(now - last_).count());
        last_ = now;
        left_ = std::min(atOnce_, left_ + seconds * perSecond_);
        const bool isThere = left_ >= 1;
        left_ = std::max(0.0, left_ - 1);
        return isThere;
    }

private:
    double atOnce_, perSecond_, left_;
    Time last_{};
};

/// Limits the messages of all viewers together. They share one token and take turns. Nobody is sent away for the
/// others' messages. Each connection waits for one turn at a time, so that all of them get equally many, whatever they
/// would like to send.
class CommonRate {
public:
    using Clock = std::chrono::steady_clock;

    /// Takes the next turn. Returns how long it is until then; zero mostly.
    Clock::duration nextTurn(Clock::time_point now)
    {
        next_ = std::max(next_, now - kBurst * kStep) + kStep;
        return std::max(next_ - now, Clock::duration::zero());
    }

    static constexpr int kPerSecond = 10000;  ///< 64 viewers who all move, with 120 views and some more.
    static constexpr int kBurst = 2000;       ///< So many without waiting, after a quiet time.

private:
    static constexpr Clock::duration kStep = std::chrono::nanoseconds(1'000'000'000 / kPerSecond);
    Clock::time_point next_{};
};

}  // namespace aeolic::stream
