#include "scaling/rows.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

const NetworkModel kNoNetwork{1e30, 0};

RankStats rankOf(double projectMs, double convolveMs)
{
    RankStats rank;
    rank.project.busyMs = projectMs;
    rank.convolve.busyMs = convolveMs;
    rank.busyMs = projectMs + convolveMs;
    return rank;
}

/// Two ranks, each stage by the slower one 6 ms in all; one rank takes 9 ms. From picture to picture the machine is
/// slower by a factor.
ScalingSamples samplesOf(const std::vector<double>& slowness)
{
    ScalingSamples samples;
    samples.of.resize(1);
    for (const double f : slowness) {
        samples.of[0].rotation.push_back({rankOf(2 * f, 3 * f), rankOf(1 * f, 4 * f)});
        samples.of[0].jumps.push_back({rankOf(2 * f, 2 * f), rankOf(1 * f, 1 * f)});
        samples.alone.push_back({rankOf(3 * f, 6 * f)});
    }
    return samples;
}

TEST(ScalingRows, WhatSlowsAMachineForAWhileIsInBothAndCancels)
{
    for (const auto& slowness : {std::vector<double>{1, 1, 1}, {1, 3, 2, 7, 1.5}}) {
        const ScalingRow row = measuredRow(samplesOf(slowness), 0, kNoNetwork);
        ASSERT_TRUE(row.speedup && row.work);
        EXPECT_NEAR(*row.speedup, 9.0 / 6.0, 1e-9);
        EXPECT_NEAR(*row.work, 10.0 / 9.0, 1e-9);
        EXPECT_NEAR(row.loadBalance, 1, 1e-9);
        for (const double balance : row.afterJump) EXPECT_NEAR(balance, 0.75, 1e-9);
    }
    EXPECT_NEAR(measuredRow(samplesOf({1, 3, 2, 7, 1.5}), 0, kNoNetwork).totalMs, 12, 1e-9) << "the median";
}

TEST(ScalingRows, WithoutOneRankThereIsNoSpeedup)
{
    ScalingSamples samples = samplesOf({1, 2});
    samples.alone.clear();
    const ScalingRow row = measuredRow(samples, 0, kNoNetwork);
    EXPECT_FALSE(row.speedup || row.paperNetworkSpeedup || row.work || row.wallSpeedup);
    EXPECT_GT(row.totalMs, 0);
}

TEST(ScalingRows, WallTimesAreComparedPictureByPicture)
{
    ScalingSamples samples = samplesOf({1, 1, 1});
    samples.of[0].wallMs = {5, 10, 50};
    samples.aloneWallMs = {9, 18, 90};
    const ScalingRow row = measuredRow(samples, 0, kNoNetwork);
    ASSERT_TRUE(row.wallSpeedup);
    EXPECT_NEAR(*row.wallSpeedup, 1.8, 1e-9);
    EXPECT_EQ(row.wallMs, 10);
}

TEST(ScalingRows, ASlowdownIsThatOfTheSamePictures)
{
    const BalancerSamples quick = samplesOf({1, 3, 2, 7, 1.5}).of[0];
    BalancerSamples slow = samplesOf({1, 3, 2, 7, 1.5}).of[0];
    // Twice as slow in most pictures, but not in that whose time is the middle one.
    for (const std::size_t picture : {0, 1, 3})
        for (RankStats& rank : slow.rotation[picture]) rank.project.busyMs *= 4;
    EXPECT_NEAR(slowdown(slow, quick, kNoNetwork).value_or(0), 12.0 / 6.0, 1e-9);
    EXPECT_NEAR(slowdown(quick, quick, kNoNetwork).value_or(0), 1, 1e-9);
    slow.rotation.pop_back();
    EXPECT_FALSE(slowdown(slow, quick, kNoNetwork));
}

TEST(ScalingRows, SteadinessIsTheMostByTheLeast)
{
    EXPECT_FALSE(steadiness({}, kNoNetwork));
    EXPECT_FALSE(steadiness({samplesOf({1})}, kNoNetwork));
    const auto three = steadiness({samplesOf({2}), samplesOf({1, 1, 9}), samplesOf({3})}, kNoNetwork);
    ASSERT_TRUE(three);
    EXPECT_NEAR(*three, 3, 1e-9);
}

}  // namespace
}  // namespace aeolic
