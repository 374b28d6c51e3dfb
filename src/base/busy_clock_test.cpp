#include "base/busy_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace aeolic {
namespace {

/// Keeps this thread busy for so much of its own CPU time.
void compute(double ms)
{
    const double end = threadCpuMs() + ms;
    while (threadCpuMs() < end) {
    }
}

TEST(BusyClock, CountsWhatIsComputedWhileItRuns)
{
    for (const BusyClock::Of of : {BusyClock::Of::process, BusyClock::Of::thread}) {
        BusyClock clock(of);
        clock.start();
        compute(20);
        clock.stop();
        EXPECT_GE(clock.lapMs(), 20);
        EXPECT_EQ(clock.lapMs(), 0) << "a lap is given once";
    }
}

/// A rank that spins while it waits for a message is not busy.
TEST(BusyClock, SpinningWhileItIsStoppedDoesNotCount)
{
    BusyClock clock;
    clock.start();
    clock.stop();
    compute(50);
    clock.start();
    clock.stop();
    EXPECT_LT(clock.lapMs(), 25);
}

TEST(BusyClock, SleepingDoesNotCount)
{
    BusyClock clock;
    clock.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    clock.stop();
    EXPECT_LT(clock.lapMs(), 25);
}

/// Ranks that are threads of one process: what the others compute is theirs.
TEST(BusyClock, OfAThreadDoesNotCountTheOthers)
{
    BusyClock ofThread(BusyClock::Of::thread), ofProcess(BusyClock::Of::process);
    ofThread.start();
    ofProcess.start();
    std::thread([] { compute(50); }).join();
    ofThread.stop();
    ofProcess.stop();
    EXPECT_LT(ofThread.lapMs(), 25);
    EXPECT_GE(ofProcess.lapMs(), 50);
}

TEST(FrameClock, StagesAddUpToTheFrame)
{
    BusyClock busy;
    FrameClock clock(busy);
    double wallMs = 0, busyMs = 0, waitWallMs = 0, waitBusyMs = 0;
    compute(20);
    clock.lap(wallMs, busyMs);
    busy.stop();  // As around a message.
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    busy.start();
    clock.lap(waitWallMs, waitBusyMs);
    EXPECT_GE(wallMs, 20);
    EXPECT_GE(busyMs, 20);
    EXPECT_GE(waitWallMs, 30);
    EXPECT_LT(waitBusyMs, 15);
    EXPECT_DOUBLE_EQ(clock.totalMs(), wallMs + waitWallMs);
    EXPECT_DOUBLE_EQ(clock.busyMs(), busyMs + waitBusyMs);
}

}  // namespace
}  // namespace aeolic
