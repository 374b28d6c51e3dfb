#pragma once

#include <chrono>
#include <string>

namespace aeolic {

/// One line on standard error that names the work and says how far it is. It appears only on a terminal and only
/// once something has taken a second, and it is wiped when done, also by an exception.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `fraction` from 0 to 1.
    void show(const std::string& what, double fraction);

    /// Removes the line until the next show().
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    bool terminal_;
    bool visible_ = false;
    Clock::time_point start_, lastShown_;
};

}  // namespace aeolic
