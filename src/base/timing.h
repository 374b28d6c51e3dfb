#pragma once

#include <time.h>

#include <chrono>

namespace aeolic {

/// Milliseconds of wall time since construction or the last lap().
class StopWatch {
public:
    double lapMs()
    {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
        start_ = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// CPU time of a clock of the C library, in milliseconds.
inline double clockMs(clockid_t clock)
{
    timespec t{};
    clock_gettime(clock, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// CPU time of the whole process, all threads, in milliseconds.
inline double processCpuMs()
{
    return clockMs(CLOCK_PROCESS_CPUTIME_ID);
}

/// CPU time of the calling thread, in milliseconds.
inline double threadCpuMs()
{
    return clockMs(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace aeolic
