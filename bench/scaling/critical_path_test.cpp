#include "scaling/critical_path.h"

#include <gtest/gtest.h>

#include <vector>

namespace aeolic {
namespace {

constexpr NetworkModel kNetwork{1e9, 10};  // A microsecond is a kilobyte; a message costs ten.

StageStats busy(double ms)
{
    StageStats stage;
    stage.busyMs = ms;
    return stage;
}

std::vector<RankStats> twoRanks()
{
    std::vector<RankStats> ranks(2);
    for (int r = 0; r < 2; ++r) ranks[std::size_t(r)].rank = r;
    ranks[0].project = busy(3);
    ranks[1].project = busy(5);
    ranks[0].convolve = busy(20);
    ranks[1].convolve = busy(11);
    ranks[0].gather = busy(1);
    ranks[0].busyMs = 24;
    ranks[1].busyMs = 16;
    return ranks;
}

std::size_t stageIndex(const std::string& name)
{
    for (std::size_t s = 0; s < kFrameStages.size(); ++s)
        if (kFrameStages[s].name == name) return s;
    ADD_FAILURE() << name;
    return 0;
}

TEST(CriticalPath, TakesTheSlowestRankOfEveryStage)
{
    const CriticalPath path = criticalPath(twoRanks(), kNetwork);
    EXPECT_DOUBLE_EQ(path.computeMs(), 5 + 20 + 1);  // Not 24, the longer of the ranks' own sums.
    EXPECT_DOUBLE_EQ(path.networkMs(), 0);
    EXPECT_DOUBLE_EQ(path.totalMs(), 26);
    EXPECT_EQ(path.stages[stageIndex("project")].slowestRank, 1);
    EXPECT_EQ(path.stages[stageIndex("convolve")].slowestRank, 0);
}

TEST(CriticalPath, ChargesWhoSendsOrReceivesMost)
{
    std::vector<RankStats> ranks = twoRanks();
    ranks[1].gather.sentBytes = 3'000'000;  // 3 ms and 10 us for the one who sends.
    ranks[1].gather.sentMessages = 1;
    ranks[0].gather.receivedBytes = 3'000'000;  // Rank 0 receives them in three messages.
    ranks[0].gather.receivedMessages = 3;
    ranks[0].convolve.sentBytes = 500'000;
    ranks[0].convolve.receivedBytes = 400'000;
    ranks[0].convolve.sentMessages = ranks[0].convolve.receivedMessages = 2;
    const CriticalPath path = criticalPath(ranks, kNetwork);
    EXPECT_DOUBLE_EQ(path.stages[stageIndex("gather")].networkMs, 3.03);
    EXPECT_DOUBLE_EQ(path.stages[stageIndex("convolve")].networkMs, 0.52);
    EXPECT_DOUBLE_EQ(path.networkMs(), 3.55);
    EXPECT_DOUBLE_EQ(path.totalMs(), 29.55);
}

TEST(CriticalPath, OfOneRankIsItsOwnTime)
{
    std::vector<RankStats> alone(1);
    for (const FrameStage& stage : kFrameStages) alone[0].*stage.stats = busy(2);
    alone[0].busyMs = 12;
    EXPECT_DOUBLE_EQ(criticalPath(alone, kNetwork).totalMs(), 12);
    EXPECT_DOUBLE_EQ(loadBalance(alone), 1);
}

TEST(LoadBalance, IsMeanOverMax)
{
    EXPECT_DOUBLE_EQ(loadBalance(twoRanks()), 20.0 / 24.0);
    std::vector<RankStats> idle = twoRanks();
    idle[1].busyMs = 0;
    EXPECT_DOUBLE_EQ(loadBalance(idle), 0.5);
    EXPECT_DOUBLE_EQ(loadBalance(std::vector<RankStats>(3)), 1);  // Nobody did anything: nobody waited.
}

}  // namespace
}  // namespace aeolic
