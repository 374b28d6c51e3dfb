#include "pipeline/median_frames.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

RankStats rankOf(double projectMs, double convolveMs, int rows)
{
    RankStats rank;
    rank.project.busyMs = projectMs;
    rank.convolve.busyMs = convolveMs;
    rank.busyMs = projectMs + convolveMs;
    rank.rows = rows;
    return rank;
}

TEST(MedianFrames, TheMiddleTimeOfEachRankAndStage)
{
    const std::vector<RanksOfFrame> medians = medianFrames({{{rankOf(1, 9, 10), rankOf(4, 5, 20)}},
                                                            {{rankOf(8, 2, 11), rankOf(4, 6, 19)}},
                                                            {{rankOf(2, 3, 12), rankOf(70, 7, 18)}}});
    ASSERT_EQ(medians.size(), 1u);
    ASSERT_EQ(medians[0].size(), 2u);
    EXPECT_EQ(medians[0][0].project.busyMs, 2);
    EXPECT_EQ(medians[0][0].convolve.busyMs, 3);
    EXPECT_EQ(medians[0][0].busyMs, 5);
    EXPECT_EQ(medians[0][1].project.busyMs, 4) << "a rank that was held up once";
    EXPECT_EQ(medians[0][1].busyMs, 10);
    EXPECT_EQ(medians[0][1].rows, 18) << "of the last repeat";
}

TEST(MedianFrames, FramesAreKeptApartAndOneRepeatIsItself)
{
    const std::vector<RanksOfFrame> medians = medianFrames({{{rankOf(1, 2, 5)}, {rankOf(3, 4, 6)}}});
    ASSERT_EQ(medians.size(), 2u);
    EXPECT_EQ(medians[0][0].busyMs, 3);
    EXPECT_EQ(medians[1][0].busyMs, 7);
}

}  // namespace
}  // namespace aeolic
