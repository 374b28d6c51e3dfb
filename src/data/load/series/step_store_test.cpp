#include "data/load/series/step_store.h"

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

TEST(StepStore, StepsThatAreNoLongerInUseAreForgotten)
{
    std::atomic<int> loads = 0;
    StepStore<Counted> store([&](double key, const ProgressReport&) {
        ++loads;
        return std::make_shared<const Counted>(key);
    });
    EXPECT_TRUE(store.hold({0, 1}, {}));
    EXPECT_FALSE(store.hold({0, 1}, {}));
    EXPECT_TRUE(store.hold({1, 2}, {}));
    EXPECT_EQ(loads, 3);
    EXPECT_EQ(Counted::alive, 2);
    EXPECT_EQ(store.held(), 2u);
    EXPECT_FALSE(store.holds(0));
    EXPECT_EQ(store.at(1)->key, 1);
    EXPECT_EQ(store.at(2)->key, 2);
    EXPECT_FALSE(store.hold({}, {}));
    EXPECT_EQ(Counted::alive, 0);
}

/// While a step is read ahead no other is begun, and nobody waits for it.
TEST(StepStore, OneStepAtATimeIsReadAhead)
{
    std::atomic<int> loads = 0;
    std::counting_semaphore<> mayLoad(0);
    StepStore<Counted> store([&](double key, const ProgressReport&) {
        ++loads;
        mayLoad.try_acquire_for(std::chrono::seconds(10));
        return std::make_shared<const Counted>(key);
    });
    store.readAhead({5});
    store.readAhead({6});  // Else it would wait for the first.
    store.readAhead({5});
    EXPECT_EQ(store.held(), 1u);
    mayLoad.release();
    EXPECT_TRUE(store.hold({5}, {}));
    EXPECT_EQ(loads, 1);
    EXPECT_EQ(store.at(5)->key, 5);
}

}  // namespace
}  // namespace aeolic
