#include "base/timing.h"

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
TEST(BusyClock, SpinningDuringAPauseDoesNotCount)
{
    BusyClock clock(BusyClock::Of::thread);
    clock.start();
    {
        const BusyClock::Pause pause(clock);
        {
            const BusyClock::Pause within(clock);
        }
        compute(50);
    }
    EXPECT_LT(clock.lapMs(), 25);
    compute(20);
    EXPECT_GE(clock.lapMs(), 20) << "it goes on afterwards";
}

TEST(BusyClock, APauseDoesNotStartAClockThatStood)
{
    BusyClock clock(BusyClock::Of::thread);
    {
        const BusyClock::Pause pause(clock);
    }
    compute(5);
    EXPECT_EQ(clock.lapMs(), 0);
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

TEST(BusyClock, LapsWhileItRuns)
{
    BusyClock clock(BusyClock::Of::thread);
    clock.start();
    compute(4);
    const double first = clock.lapMs();
    compute(8);
    const double second = clock.lapMs();
    EXPECT_GE(first, 4);
    EXPECT_GE(second, 8);
    clock.stop();
    clock.stop();  // What an error finds already stopped.
    EXPECT_LT(clock.lapMs(), 4);
}

}  // namespace
}  // namespace aeolic
