#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

namespace aeolic {

/// One line on standard error that names the work and says how far it is. It appears only on a terminal and only
/// once something has taken a second, and it is wiped when done, also by an exception.
class ProgressLine {
public:
    ProgressLine() = default;
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `fraction` from 0 to 1.
    void show(const std::string& what, double fraction)
    {
        using namespace std::chrono_literals;
        const auto now = Clock::now();
        if (!terminal_ || now - start_ < 1s || (visible_ && now - lastShown_ < 100ms)) return;
        lastShown_ = now;
        visible_ = true;
        std::fprintf(stderr, "\r\033[K%s %3.0f %%", what.c_str(), 100 * std::clamp(fraction, 0.0, 1.0));
        std::fflush(stderr);
    }

    /// Removes the line until the next show().
    void clear()
    {
        if (!visible_) return;
        std::fputs("\r\033[K", stderr);
        std::fflush(stderr);
        visible_ = false;
    }

private:
    using Clock = std::chrono::steady_clock;

    bool terminal_ = isatty(STDERR_FILENO) != 0;
    bool visible_ = false;
    Clock::time_point start_ = Clock::now(), lastShown_ = start_;
};

}  // namespace aeolic
