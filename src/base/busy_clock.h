#pragma once

#include "base/timing.h"

namespace aeolic {

/// CPU time a rank spends computing, waiting and communicating left out: some communicators spin while they wait.
class BusyClock {
public:
    /// Whose CPU time counts: a process's, all threads; or one thread's, where ranks are threads that work alone.
    enum class Of { process, thread };

    explicit BusyClock(Of of = Of::process) : of_(of) {}
    BusyClock(const BusyClock&) = delete;
    BusyClock& operator=(const BusyClock&) = delete;

    void start()
    {
        running_ = true;
        startMs_ = nowMs();
    }

    /// Nothing, where it is stopped already: an error may come while the rank waits for others.
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
        const double ms = totalMs_ - lappedMs_;
        lappedMs_ = totalMs_;
        return ms;
    }

private:
    double nowMs() const { return of_ == Of::process ? processCpuMs() : threadCpuMs(); }

    Of of_;
    bool running_ = false;
    double startMs_ = 0, totalMs_ = 0, lappedMs_ = 0;
};

}  // namespace aeolic
