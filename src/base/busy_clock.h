#pragma once

#include <mutex>

#include "base/timing.h"

namespace aeolic {

/// CPU time a rank spends computing, waiting and communicating left out: some communicators spin while they wait.
class BusyClock {
public:
    /// Whose CPU time counts: a process's, all threads; or one thread's, where ranks are threads that work alone.
    enum class Of { process, thread };

    /// `turn`: held while the clock runs. Ranks that share one compute one at a time, and none is slowed by another:
    /// what a measurement of many ranks on few cores needs.
    explicit BusyClock(Of of = Of::process, std::mutex* turn = nullptr) : of_(of), turn_(turn) {}
    ~BusyClock() { stop(); }
    BusyClock(const BusyClock&) = delete;
    BusyClock& operator=(const BusyClock&) = delete;

    /// Waits for the turn, where there is one.
    void start()
    {
        if (turn_) turn_->lock();
        running_ = true;
        startMs_ = nowMs();
    }

    /// Nothing, where it is stopped already: an error may come while the rank waits for others.
    void stop()
    {
        if (!running_) return;
        totalMs_ += nowMs() - startMs_;
        running_ = false;
        if (turn_) turn_->unlock();
    }

    /// Since the last lap. The turn is kept.
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
    std::mutex* turn_;
    bool running_ = false;
    double startMs_ = 0, totalMs_ = 0, lappedMs_ = 0;
};

}  // namespace aeolic
