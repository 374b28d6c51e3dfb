#pragma once

#include <algorithm>
#include <chrono>

namespace aeolic::stream {

/// So many at once, and after that so many a second.
class Allowance {
public:
    using Time = std::chrono::steady_clock::time_point;

    Allowance(double atOnce, double perSecond) : atOnce_(atOnce), perSecond_(perSecond), left_(atOnce) {}

    /// Takes one. False where none is left.
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

}  // namespace aeolic::stream
