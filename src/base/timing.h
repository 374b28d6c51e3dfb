#pragma once

#include <time.h>

#include <chrono>
#include <utility>

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

/// What a clock of the C library shows, in milliseconds.
inline double clockMs(clockid_t clock)
{
    timespec t{};
    clock_gettime(clock, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// CPU time of the calling thread, in milliseconds.
inline double threadCpuMs()
{
    return clockMs(CLOCK_THREAD_CPUTIME_ID);
}

/// Time a rank spends computing. It stands while the rank waits for others: some communicators spin while they wait,
/// and that would count.
class BusyClock {
public:
    /// Which time counts: the CPU time of a process with all its threads; that of one thread, where ranks are threads
    /// that work alone; or wall time, which tells how fast a rank is with all its threads together.
    enum class Of { process, thread, wall };

    explicit BusyClock(Of of = Of::process) : of_(of) {}
    BusyClock(const BusyClock&) = delete;
    BusyClock& operator=(const BusyClock&) = delete;

    Of of() const { return of_; }

    void start()
    {
        running_ = true;
        startMs_ = nowMs();
    }

    /// Does nothing to a clock that stands.
    void stop()
    {
        if (!running_) return;
        totalMs_ += nowMs() - startMs_;
        running_ = false;
    }

    /// Since the last lap.
    double lapMs()
    {
        if (running_) {
            const double now = nowMs();
            totalMs_ += now - startMs_;
            startMs_ = now;
        }
        return totalMs_ - std::exchange(lappedMs_, totalMs_);
    }

    /// The clock stands while this exists, and goes on afterwards if it ran before.
    class Pause {
    public:
        explicit Pause(BusyClock& clock) : clock_(clock), ran_(clock.running_) { clock_.stop(); }
        ~Pause()
        {
            if (ran_) clock_.start();
        }
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        BusyClock& clock_;
        bool ran_;
    };

private:
    double nowMs() const
    {
        if (of_ == Of::wall) return clockMs(CLOCK_MONOTONIC);
        return of_ == Of::process ? clockMs(CLOCK_PROCESS_CPUTIME_ID) : threadCpuMs();
    }

    Of of_;
    bool running_ = false;
    double startMs_ = 0, totalMs_ = 0, lappedMs_ = 0;
};

}  // namespace aeolic
