#include "cluster/balance/speed_history.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(SpeedHistory, TellsASlowNodeFromMuchWork)
{
    SpeedHistory history;
    EXPECT_TRUE(relativeSpeeds(history).empty());
    for (int frame = 0; frame < 6; ++frame)
        addFrame(history, {300, 100, 100}, {30, 10, 20});  // The last is half as fast.
    const std::vector<double> speeds = relativeSpeeds(history);
    EXPECT_NEAR(speeds[0] / speeds[1], 1.0, 0.03);
    EXPECT_NEAR(speeds[1] / speeds[2], 2.0, 0.1);
}

TEST(SpeedHistory, ARankThatHadNothingToDoIsTakenForAverage)
{
    SpeedHistory history;
    for (int frame = 0; frame < 2; ++frame) addFrame(history, {100, 0, 100}, {10, 0, 10});
    EXPECT_DOUBLE_EQ(relativeSpeeds(history)[1], 1.0);
    addFrame(history, {100, 0.1, 100}, {10, 0.2, 10});  // Fixed costs on next to nothing.
    EXPECT_GT(relativeSpeeds(history)[1], 0.4);
}

TEST(SpeedHistory, FollowsANodeThatIsThrottled)
{
    SpeedHistory history;
    for (int frame = 0; frame < 20; ++frame) addFrame(history, {100, 100}, {10, 10});
    for (int frame = 0; frame < 15; ++frame) addFrame(history, {100, 100}, {10, 40});
    EXPECT_NEAR(relativeSpeeds(history)[0] / relativeSpeeds(history)[1], 4.0, 0.5);
}

/// Whoever came last to its libraries and pages is not taken for slow.
TEST(SpeedHistory, TheFirstFrameCountsForNothing)
{
    SpeedHistory history;
    addFrame(history, {100, 100}, {900, 10});
    EXPECT_TRUE(relativeSpeeds(history).empty());
    addFrame(history, {100, 100}, {10, 10});
    EXPECT_EQ(relativeSpeeds(history), (std::vector<double>{1, 1}));
}

/// New memory, another program: what happens once is not believed, and is forgotten.
TEST(SpeedHistory, OneFrameAloneChangesLittle)
{
    SpeedHistory history;
    for (int frame = 0; frame < 2; ++frame) addFrame(history, {100, 100, 100}, {10, 10, 10});
    addFrame(history, {100, 100, 100}, {10, 900, 10});
    std::vector<double> speeds = relativeSpeeds(history);
    EXPECT_GT(speeds[1] / speeds[0], 0.6);
    for (int frame = 0; frame < 10; ++frame) addFrame(history, {100, 100, 100}, {10, 10, 10});
    speeds = relativeSpeeds(history);
    EXPECT_NEAR(speeds[1] / speeds[0], 1.0, 0.05);
}

TEST(SpeedHistory, WhoHasNothingToDoIsGivenAnotherChance)
{
    SpeedHistory history;
    for (int frame = 0; frame < 20; ++frame) addFrame(history, {100, 100, 100}, {10, 80, 10});
    const auto byOthers = [&] { return relativeSpeeds(history)[1] / relativeSpeeds(history)[0]; };
    EXPECT_LT(byOthers(), 0.2);
    for (int frame = 0; frame < 20; ++frame) addFrame(history, {150, 0, 150}, {15, 0, 15});
    EXPECT_GT(byOthers(), 0.7);
}

TEST(SpeedHistory, AnotherGroupStartsAnew)
{
    SpeedHistory history;
    addFrame(history, {100, 100}, {10, 40});
    addFrame(history, {100, 100}, {10, 40});
    addFrame(history, {1, 1, 1}, {1, 1, 1});
    EXPECT_TRUE(relativeSpeeds(history).empty());
    addFrame(history, {1, 1, 1}, {1, 1, 1});
    EXPECT_EQ(relativeSpeeds(history), (std::vector<double>{1, 1, 1}));
}

}  // namespace
}  // namespace aeolic
