#include "cluster/balance/balancer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "description/choices.h"
#include "scaling/simulated_cluster.h"

namespace aeolic {
namespace {

RowCoverage uniformRows(int height, std::int64_t pixels)
{
    return {height, 1, std::vector<std::int64_t>(std::size_t(height), pixels)};
}

/// A body with a spout, a handle and a knob on a lid, as a teapot's silhouette has them: empty rows above and below,
/// steps where parts begin, most pixels in the middle.
RowCoverage teapotRows(int height, int width)
{
    RowCoverage rows{height, 1, {}};
    for (int y = 0; y < height; ++y) {
        const double t = (y + 0.5) / height;
        double share = 0;
        if (t > 0.22 && t < 0.30) share += 0.08;                                                      // Knob.
        if (t > 0.30 && t < 0.80) share += 0.55 * std::sqrt(1 - std::pow((t - 0.55) / 0.27, 2.0));    // Body.
        if (t > 0.38 && t < 0.62) share += 0.12 + 0.06 * std::cos((t - 0.5) * 4 * std::numbers::pi);  // Spout, handle.
        rows.coveredPerRow.push_back(std::int64_t(share * width));
    }
    return rows;
}

void expectPartition(const Stripes& stripes, const BalanceInput& input)
{
    ASSERT_EQ(stripes.ranks(), input.ranks);
    ASSERT_EQ(stripes.firstRow.front(), 0);
    ASSERT_EQ(stripes.firstRow.back(), input.height);
    ASSERT_TRUE(std::is_sorted(stripes.firstRow.begin(), stripes.firstRow.end()));
}

/// Mean over maximum of what the ranks' stripes take.
double balanceOf(const Stripes& stripes, const RowCoverage& truth, const std::vector<double>& speeds = {},
                 const StripeCosts& costs = {})
{
    const RowSums sums(truth);
    double total = 0, slowest = 0;
    for (int r = 0; r < stripes.ranks(); ++r) {
        const auto i = std::size_t(r);
        const double ms =
            stripeCost(sums, costs, stripes.firstRow[i], stripes.firstRow[i + 1]) / (speeds.empty() ? 1.0 : speeds[i]);
        total += ms;
        slowest = std::max(slowest, ms);
    }
    return total / stripes.ranks() / slowest;
}

class EveryBalancer : public ::testing::TestWithParam<std::string> {
protected:
    Balance balance = *choiceNamed<Balance>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Names, EveryBalancer, ::testing::Values("static", "timing", "pixels", "hybrid"),
                         [](const auto& balancer) { return balancer.param; });

TEST_P(EveryBalancer, PartitionsWhateverItIsGiven)
{
    std::mt19937 random(7);
    const auto below = [&](int n) { return int(random() % std::uint32_t(n)); };
    for (int trial = 0; trial < 400; ++trial) {
        BalanceInput input;
        input.height = 1 + below(trial % 2 ? 9 : 500);
        input.ranks = 1 + below(40);
        const int factor = 1 + below(6);
        input.coverage = {input.height, factor, {}};
        for (int y = 0; y < input.height; y += factor) input.coverage.coveredPerRow.push_back(below(3) * below(200));
        input.lastStripes = equalStripes(1 + below(300), 1 + below(20));
        for (int r = 0; r < input.lastStripes.ranks(); ++r) input.lastBusyMs.push_back(below(3) * 0.7);
        for (int r = 0; r < input.ranks; ++r) input.speeds.push_back(below(8) * 0.3);
        input.costs = {below(200), below(11) * 0.1, below(3) * 7.7};
        const Stripes stripes = balancedStripes(balance, input);
        expectPartition(stripes, input);
        EXPECT_EQ(stripes, balancedStripes(balance, input));
    }
}

TEST_P(EveryBalancer, StartsWithoutHistory)
{
    BalanceInput input;
    input.height = 800;
    input.ranks = 8;
    if (needsCoverage(balance)) input.coverage = coarsened(teapotRows(800, 800), 5);
    expectPartition(balancedStripes(balance, input), input);
}

TEST_P(EveryBalancer, NothingCoveredAndNoTimeMeansEqualRows)
{
    BalanceInput input;
    input.height = 103;
    input.ranks = 5;
    input.coverage = uniformRows(103, 0);
    input.lastStripes = {{0, 90, 91, 92, 93, 103}};
    input.lastBusyMs = {0, 0, 0, 0, 0};
    input.costs.row = 3;
    EXPECT_EQ(balancedStripes(balance, input), equalStripes(103, 5));
}

TEST_P(EveryBalancer, OneRankGetsEverything)
{
    BalanceInput input;
    input.height = 77;
    input.coverage = teapotRows(77, 77);
    EXPECT_EQ(balancedStripes(balance, input).firstRow, (std::vector<int>{0, 77}));
}

TEST_P(EveryBalancer, AOneRowImageOnThirteenRanksIsDrawnByOne)
{
    BalanceInput input;
    input.height = 1;
    input.ranks = 13;
    input.coverage = uniformRows(1, 40);
    const Stripes stripes = balancedStripes(balance, input);
    expectPartition(stripes, input);
    EXPECT_EQ(stripes.rows(stripes.ownerOf(0)), 1);
}

TEST(BalancerNames, AValueThatIsNoneIsRefused)
{
    EXPECT_THROW(balancedStripes(Balance(7), {}), std::logic_error);
}

class CountingBalancer : public ::testing::TestWithParam<std::string> {
protected:
    Balance balance = *choiceNamed<Balance>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Names, CountingBalancer, ::testing::Values("pixels", "hybrid"),
                         [](const auto& balancer) { return balancer.param; });

TEST_P(CountingBalancer, AStepIsSplitWhereItsAreaIsHalf)
{
    BalanceInput input;
    input.height = 100;
    input.ranks = 2;
    input.coverage = uniformRows(100, 0);
    for (std::size_t y = 60; y < 100; ++y) input.coverage.coveredPerRow[y] = 10;
    EXPECT_EQ(balancedStripes(balance, input).firstRow[1], 80);
    for (std::size_t y = 0; y < 60; ++y) input.coverage.coveredPerRow[y] = 1;  // 60 pixels above, 400 below.
    EXPECT_EQ(balancedStripes(balance, input).firstRow[1], 77);
}

TEST_P(CountingBalancer, AFifthOfTheResolutionIsEnoughForATeapot)
{
    for (const int ranks : {2, 3, 4, 5, 8, 13, 16, 32, 64}) {
        BalanceInput input;
        input.height = 2160;
        input.ranks = ranks;
        const RowCoverage truth = teapotRows(2160, 3840);
        input.coverage = coarsened(truth, 5);
        EXPECT_GE(balanceOf(balancedStripes(balance, input), truth), 0.9) << ranks;
    }
}

TEST_P(CountingBalancer, AHeightThatFiveDoesNotDivide)
{
    BalanceInput input;
    input.height = 803;
    input.ranks = 8;
    const RowCoverage truth = teapotRows(803, 800);
    input.coverage = coarsened(truth, 5);
    ASSERT_EQ(input.coverage.coveredPerRow.size(), 161U);
    EXPECT_GE(balanceOf(balancedStripes(balance, input), truth), 0.95);
}

TEST(PixelsBalancer, FollowsTheInvertedHistogram)
{
    BalanceInput input;
    input.height = 20;
    input.ranks = 4;
    input.coverage = {20, 5, {0, 8, 4, 4}};  // Accumulated: 0, 8, 12, 16 of 16; intervals of 4.
    EXPECT_EQ(balancedStripes(Balance::pixels, input).firstRow, (std::vector<int>{0, 8, 10, 15, 20}));
}

TEST(TimingBalancer, CostPerRowIsTheLastFramesTime)
{
    BalanceInput input;
    input.height = 100;
    input.ranks = 2;
    input.lastStripes = {{0, 50, 100}};
    input.lastBusyMs = {10, 30};  // 0.2 and 0.6 ms a row; half of 40 ms is reached 10 ms into the lower stripe: at 67.
    EXPECT_EQ(balancedStripes(Balance::timing, input).firstRow[1], 59) << "half of the way";
}

TEST(TimingBalancer, TwoRanksOneTwiceAsFastEndUpAtTwoToOne)
{
    BalanceInput input;
    input.height = 900;
    input.ranks = 2;
    input.lastStripes = equalStripes(900, 2);
    for (int frame = 0; frame < 12; ++frame) {
        input.lastBusyMs = {double(input.lastStripes.rows(0)), 2.0 * input.lastStripes.rows(1)};
        input.lastStripes = balancedStripes(Balance::timing, input);
    }
    EXPECT_NEAR(input.lastStripes.firstRow[1], 600, 1);
}

TEST(TimingBalancer, SettlesOnASteadyPicture)
{
    const RowCoverage truth = teapotRows(800, 800);
    const RowSums sums(truth);
    for (const int ranks : {2, 3, 4, 5, 6, 7, 8, 13}) {
        BalanceInput input;
        input.height = 800;
        input.ranks = ranks;
        for (int frame = 0; frame < 15; ++frame) {
            input.lastStripes = balancedStripes(Balance::timing, input);
            input.lastBusyMs.clear();
            for (int r = 0; r < ranks; ++r)
                input.lastBusyMs.push_back(sums.pixels(input.lastStripes.firstRow[std::size_t(r)],
                                                       input.lastStripes.firstRow[std::size_t(r) + 1]));
            // Not now and then, either: boundaries that swing to and fro are never where they should be for long.
            if (frame > 10) {
                EXPECT_GE(balanceOf(input.lastStripes, truth), 0.9) << ranks << " ranks, frame " << frame;
            }
        }
    }
    EXPECT_LT(balanceOf(equalStripes(800, 8), truth), 0.7) << "or there was nothing to settle";
}

TEST(TimingBalancer, AnotherHeightOrGroupKeepsTheShape)
{
    BalanceInput input;
    input.height = 200;
    input.ranks = 4;
    input.lastStripes = {{0, 80, 100}};
    input.lastBusyMs = {5, 5};
    EXPECT_EQ(balancedStripes(Balance::timing, input).firstRow, (std::vector<int>{0, 80, 160, 180, 200}));
}

TEST(HybridBalancer, TwoRanksOneTwiceAsFastShareTwoToOne)
{
    BalanceInput input;
    input.height = 90;
    input.ranks = 2;
    input.coverage = uniformRows(90, 100);
    input.speeds = {2, 1};
    EXPECT_EQ(balancedStripes(Balance::hybrid, input).firstRow[1], 60);
    input.speeds = {1, 2};
    EXPECT_EQ(balancedStripes(Balance::hybrid, input).firstRow[1], 30);
}

TEST(HybridBalancer, InnerStripesPayForTwoGuardsAndGetFewerRows)
{
    BalanceInput input;
    input.height = 100;
    input.ranks = 3;
    input.coverage = uniformRows(100, 10);
    input.costs = {10, 0.5, 0};  // A guard costs as much as 5 rows: 35 + 5 = 30 + 2 * 5.
    const Stripes stripes = balancedStripes(Balance::hybrid, input);
    EXPECT_EQ(stripes.rows(1), 30);
    EXPECT_EQ(stripes.rows(0), 35);
}

TEST(HybridBalancer, EmptyRowsAreNotFree)
{
    BalanceInput input;
    input.height = 100;
    input.ranks = 2;
    input.coverage = uniformRows(100, 0);
    for (std::size_t y = 0; y < 60; ++y) input.coverage.coveredPerRow[y] = 10;
    input.costs.row = 10;  // 20 a row above, 10 below: 1600 in all.
    EXPECT_EQ(balancedStripes(Balance::hybrid, input).firstRow[1], 40);
}

/// The same number of pixels: those in four pieces a row (a body, its handle, its spout) take longer than those in one.
TEST(HybridBalancer, RunsOfPixelsCost)
{
    BalanceInput input;
    input.height = 100;
    input.ranks = 2;
    input.coverage = uniformRows(100, 20);
    input.coverage.runsPerRow.assign(100, 1);
    for (std::size_t y = 0; y < 40; ++y) input.coverage.runsPerRow[y] = 4;
    const auto firstOfSecond = [&] { return balancedStripes(Balance::hybrid, input).firstRow[1]; };
    EXPECT_EQ(firstOfSecond(), 50);
    input.costs.run = 10;  // 60 a row above, 30 below: 4200 in all.
    EXPECT_EQ(firstOfSecond(), 35);
    input.coverage.runsPerRow.clear();
    EXPECT_EQ(firstOfSecond(), 50) << "not known";
}

TEST(HybridBalancer, FindsTheBestWholeRows)
{
    // All partitions of a small image among three ranks, against what the search finds.
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        BalanceInput input;
        input.height = 12;
        input.ranks = 3;
        input.coverage = uniformRows(12, 0);
        for (auto& pixels : input.coverage.coveredPerRow) pixels = std::int64_t(random() % 50);
        for (int y = 0; y < input.height; ++y) input.coverage.runsPerRow.push_back(std::int64_t(random() % 3));
        input.speeds = {1.0 + double(random() % 3), 1.0, 0.5 + double(random() % 2)};
        input.costs = {int(random() % 4), double(random() % 3) * 0.5, double(random() % 2), 0, double(random() % 9)};
        const RowSums sums(input.coverage);
        const auto slowest = [&](int a, int b) {
            return std::max({stripeCost(sums, input.costs, 0, a) / input.speeds[0],
                             stripeCost(sums, input.costs, a, b) / input.speeds[1],
                             stripeCost(sums, input.costs, b, 12) / input.speeds[2]});
        };
        double best = slowest(0, 12);
        for (int a = 0; a <= 12; ++a)
            for (int b = a; b <= 12; ++b) best = std::min(best, slowest(a, b));
        const Stripes found = balancedStripes(Balance::hybrid, input);
        EXPECT_NEAR(slowest(found.firstRow[1], found.firstRow[2]), best, 1e-6 * best) << trial;
    }
}

/// One row takes as long as all others together, and the fastest rank alone can take it in the best time. That leaves
/// the others free: their shares are as their speeds, and not just anything that is no slower.
TEST(HybridBalancer, RowsBesideOneThatDominatesAreSharedBySpeed)
{
    const auto shared = [](std::size_t heavy, std::vector<double> speeds) {
        BalanceInput input;
        input.height = 41;
        input.ranks = int(speeds.size());
        input.coverage = uniformRows(41, 1);
        input.coverage.coveredPerRow[heavy] = 60;  // Of 100 in all.
        input.speeds = std::move(speeds);
        return balancedStripes(Balance::hybrid, input).firstRow;
    };
    EXPECT_EQ(shared(0, {2, 1, 1}), (std::vector<int>{0, 1, 16, 41})) << "half, three quarters";
    EXPECT_EQ(shared(40, {1, 1, 2}), (std::vector<int>{0, 25, 40, 41})) << "a quarter, half";
    EXPECT_EQ(shared(0, {10, 3, 2, 5}), (std::vector<int>{0, 1, 6, 16, 41})) << "50, 65 and 75 hundredths";
    EXPECT_EQ(shared(40, {5, 2, 3, 10}), (std::vector<int>{0, 25, 35, 40, 41})) << "25, 35 and 50 hundredths";
}

TEST(HybridBalancer, UnequalNodesWithGuardsOnATeapot)
{
    for (const int ranks : {2, 3, 8, 16, 32}) {
        BalanceInput input;
        input.height = 2160;
        input.ranks = ranks;
        const RowCoverage truth = teapotRows(2160, 3840);
        input.coverage = coarsened(truth, 5);
        input.costs = {130, 0.05, 100};
        for (int r = 0; r < ranks; ++r) input.speeds.push_back(r % 3 == 0 ? 2.0 : 1.0);
        EXPECT_GE(balanceOf(balancedStripes(Balance::hybrid, input), truth, input.speeds, input.costs), 0.9) << ranks;
    }
}

}  // namespace
}  // namespace aeolic
