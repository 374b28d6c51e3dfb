#pragma once

#include "base/timing.h"

namespace aeolic {

/// CPU time a rank spends computing, waiting and communicating left out: some communicators spin while they wait.
class BusyClock {
public:
    /// Whose CPU time counts: a process's, all threads; or one thread's, where ranks are threads that work alone.
    enum class Of { process, thread };

    explicit BusyClock(Of of = Of::process) : of_(of) {}

    void start() { startMs_ = nowMs(); }
    void stop() { totalMs_ += nowMs() - startMs_; }

    /// Since the last lap; to be called while stopped.
    double lapMs()
    {
        const double ms = totalMs_ - lappedMs_;
        lappedMs_ = totalMs_;
        return ms;
    }

private:
    double nowMs() const { return of_ == Of::process ? processCpuMs() : threadCpuMs(); }

    Of of_;
    double startMs_ = 0, totalMs_ = 0, lappedMs_ = 0;
};

/// Wall and busy time of a frame, stage by stage.
class FrameClock {
public:
    explicit FrameClock(BusyClock& busy) : busy_(busy) { busy_.start(); }
    ~FrameClock() { busy_.stop(); }
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    /// Ends a stage.
    void lap(double& wallMs, double& busyMs)
    {
        busy_.stop();
        wallMs = watch_.lapMs();
        busyMs = busy_.lapMs();
        totalMs_ += wallMs;
        busyMs_ += busyMs;
        busy_.start();
    }
    double totalMs() const { return totalMs_; }
    double busyMs() const { return busyMs_; }

private:
    BusyClock& busy_;
    StopWatch watch_;
    double totalMs_ = 0, busyMs_ = 0;
};

}  // namespace aeolic
