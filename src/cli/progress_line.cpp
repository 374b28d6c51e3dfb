#include "cli/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace aeolic {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), lastShown_(start_) {}

ProgressLine::~ProgressLine()
{
    clear();
}

void ProgressLine::show(const std::string& what, double fraction)
{
    using namespace std::chrono_literals;
    const auto now = Clock::now();
    if (!terminal_ || now - start_ < 1s || (visible_ && now - lastShown_ < 100ms)) return;
    lastShown_ = now;
    visible_ = true;
    std::fprintf(stderr, "\r\033[K%s %3.0f %%", what.c_str(), 100 * std::clamp(fraction, 0.0, 1.0));
    std::fflush(stderr);
}

void ProgressLine::clear()
{
    if (!visible_) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    visible_ = false;
}

}  // namespace aeolic
