#include "data/load/series/series.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <semaphore>

namespace aeolic {
namespace {

/// Steps that know their key, and how many of them there are.
struct Counted {
    explicit Counted(double itsKey) : key(itsKey) { ++alive; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() { --alive; }
    double key;
    inline static std::atomic<int> alive = 0;
};

Track movingTrack()
{
    Track track;
    track.times = {0, 1};
    return track;
}

Around momentOf(double key)
{
    return {key, key, 0};
}

TEST(Series, StepsThatAreNoLongerInUseAreForgotten)
{
    std::atomic<int> loads = 0;
    const Track track = movingTrack();
    Series<Counted> series(track, [&](double key, const ProgressReport&) {
        ++loads;
        return std::make_shared<const Counted>(key);
    });
    EXPECT_TRUE(series.hold({0, 1, 0.5}, {}));
    EXPECT_FALSE(series.hold({0, 1, 0.5}, {}));
    EXPECT_TRUE(series.hold({1, 2, 0.5}, {}));
    EXPECT_EQ(loads, 3);
    EXPECT_EQ(Counted::alive, 2);
    EXPECT_EQ(series.held(), 2u);
    EXPECT_FALSE(series.holds(0));
    EXPECT_EQ(series.step(1)->key, 1);
    EXPECT_EQ(series.step(2)->key, 2);
    series.forget();
    EXPECT_EQ(Counted::alive, 0);
}

/// While a step is read ahead no other is begun, and nobody waits for it.
TEST(Series, OneStepAtATimeIsReadAhead)
{
    std::atomic<int> loads = 0;
    std::counting_semaphore<> mayLoad(0);
    const Track track = movingTrack();
    Series<Counted> series(track, [&](double key, const ProgressReport&) {
        ++loads;
        mayLoad.try_acquire_for(std::chrono::seconds(10));
        return std::make_shared<const Counted>(key);
    });
    series.readAhead(momentOf(5));
    series.readAhead(momentOf(6));  // Else it would wait for the first.
    series.readAhead(momentOf(5));
    EXPECT_EQ(series.held(), 1u);
    mayLoad.release();
    EXPECT_TRUE(series.hold(momentOf(5), {}));
    EXPECT_EQ(loads, 1);
    EXPECT_EQ(series.step(5)->key, 5);
}

}  // namespace
}  // namespace aeolic
