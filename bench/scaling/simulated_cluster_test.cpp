#include "scaling/simulated_cluster.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

constexpr NetworkModel kNoNetwork{1e300, 0};

RowCoverage uniformRows(int height, std::int64_t pixels)
{
    return {height, 1, std::vector<std::int64_t>(std::size_t(height), pixels)};
}

/// 1 us per covered pixel, all in the LIC stage; nothing else costs anything.
SimulatedCluster convolveOnly(int ranks, const std::string& balancer)
{
    SimulatedCluster cluster;
    cluster.ranks = ranks;
    cluster.balancer = balancer;
    cluster.network = kNoNetwork;
    cluster.imageWidth = 1000;
    cluster.costs.convolvePixelNs = 1000;
    return cluster;
}

SimulatedFrame oneFrame(const SimulatedCluster& cluster, const RowCoverage& coverage)
{
    return simulate(cluster, std::span(&coverage, 1)).front();
}

TEST(Simulator, AFullImageSpeedsUpWithTheRanks)
{
    for (const int ranks : {1, 2, 4, 8}) {
        const SimulatedFrame frame = oneFrame(convolveOnly(ranks, "static"), uniformRows(800, 1000));
        EXPECT_NEAR(frame.totalMs(), 800.0 / ranks, 1e-9) << ranks;
        EXPECT_NEAR(frame.balance(), 1.0, 1e-12);
    }
}

TEST(Simulator, StaticStripesOverAQuarterFullImageLeaveTheRestIdle)
{
    RowCoverage quarter = uniformRows(800, 0);
    for (std::size_t y = 0; y < 200; ++y) quarter.coveredPerRow[y] = 1000;
    const SimulatedFrame equal = oneFrame(convolveOnly(4, "static"), quarter);
    EXPECT_NEAR(equal.totalMs(), 200, 1e-9);
    EXPECT_NEAR(equal.balance(), 0.25, 1e-12);
    for (const char* balancer : {"pixels", "hybrid"}) {
        const SimulatedFrame balanced = oneFrame(convolveOnly(4, balancer), quarter);
        EXPECT_NEAR(balanced.totalMs(), 50, 1e-9) << balancer;
    }
}

TEST(Simulator, TimingNeedsFramesToSettle)
{
    RowCoverage quarter = uniformRows(800, 0);
    for (std::size_t y = 0; y < 200; ++y) quarter.coveredPerRow[y] = 1000;
    const std::vector<RowCoverage> frames(14, quarter);
    const std::vector<SimulatedFrame> simulated = simulate(convolveOnly(4, "timing"), frames);
    EXPECT_NEAR(simulated.front().totalMs(), 200, 1e-9);
    EXPECT_NEAR(simulated[1].totalMs(), 125, 1.0);  // Half of the way from 200 rows to 50.
    EXPECT_NEAR(simulated.back().totalMs(), 50, 1.0);
}

TEST(Simulator, HybridLearnsWhoIsSlow)
{
    SimulatedCluster cluster = convolveOnly(2, "hybrid");
    cluster.speeds = {1, 0.5};
    const std::vector<RowCoverage> frames(8, uniformRows(900, 1000));
    const std::vector<SimulatedFrame> simulated = simulate(cluster, frames);
    EXPECT_NEAR(simulated.front().totalMs(), 900, 1e-9);       // 450 rows at half the speed.
    EXPECT_NEAR(simulated.back().totalMs(), 600, 0.03 * 600);  // 600 rows, and 300 at half the speed.
}

TEST(Simulator, GuardsThatAreProjectedAgainCostBothNeighbours)
{
    SimulatedCluster cluster = convolveOnly(4, "static");
    cluster.costs = {};
    cluster.costs.projectPixelNs = 1000;
    cluster.guardRows = 30;
    cluster.guardSource = GuardSource::project;
    const SimulatedFrame frame = oneFrame(cluster, uniformRows(800, 1000));
    EXPECT_NEAR(frame.projectMs, 200 + 2 * 30, 1e-9);
    EXPECT_NEAR(frame.busyMs.front(), 200 + 30, 1e-9);
    EXPECT_EQ(frame.guardPixels, 6 * 30 * 1000);
    EXPECT_EQ(frame.guardNetworkMs, 0);
}

TEST(Simulator, GuardsThatAreReceivedCostTheNetwork)
{
    SimulatedCluster cluster = convolveOnly(4, "static");
    cluster.network = {1e6, 100};  // 1 us per byte, 0.1 ms per message.
    cluster.guardRows = 30;
    cluster.guardPixelBytes = 2;
    cluster.imagePixelBytes = 0;
    const SimulatedFrame frame = oneFrame(cluster, uniformRows(800, 1000));
    EXPECT_NEAR(frame.guardNetworkMs, 2 * (0.1 + 30 * 1000 * 2 * 1e-3), 1e-9);  // An inner rank: two messages.
    EXPECT_EQ(frame.projectMs, 0);
}

TEST(Simulator, AGuardMaySpanSeveralStripes)
{
    SimulatedCluster cluster = convolveOnly(4, "static");
    cluster.network = {1e300, 100};
    cluster.guardRows = 25;  // Stripes have 10 rows: inner ranks need all others' rows.
    const SimulatedFrame frame = oneFrame(cluster, uniformRows(40, 1000));
    EXPECT_NEAR(frame.guardNetworkMs, 3 * 0.1, 1e-9);
    EXPECT_EQ(frame.messages, 4 * 3 + 3);  // The last three bring the picture.
}

TEST(Simulator, ThePictureComesTogetherOnRankZero)
{
    SimulatedCluster cluster = convolveOnly(8, "static");
    cluster.network = {1e6, 100};
    cluster.imagePixelBytes = 3;
    cluster.costs = {};
    const SimulatedFrame frame = oneFrame(cluster, uniformRows(800, 1));
    const int columns = 4 + 100 * 8, pixels = 100 * 3;  // What each of the others sends.
    EXPECT_NEAR(frame.gatherNetworkMs, 7 * (0.1 + (columns + pixels) * 1e-3), 1e-9);
    EXPECT_EQ(frame.computeMs(), 0);
    EXPECT_EQ(frame.sentBytes, 7 * (columns + pixels));
    cluster.costs.packPixelNs = 5000;
    EXPECT_NEAR(oneFrame(cluster, uniformRows(800, 1)).gatherMs, 0.5, 1e-9);
}

TEST(Simulator, BackgroundStaysWhereItIs)
{
    SimulatedCluster cluster = convolveOnly(4, "static");
    cluster.network = {1e6, 100};
    cluster.costs = {};
    RowCoverage some = uniformRows(800, 0);
    for (const std::size_t y : {10, 250, 390, 599}) some.coveredPerRow[y] = 5;  // Two are in the second stripe.
    const SimulatedFrame frame = oneFrame(cluster, some);
    const int columns = 3 * (4 + 200 * 8), pixels = 3 * 5 * 3;  // The first row is rank 0's.
    EXPECT_NEAR(frame.gatherNetworkMs, 3 * 0.1 + (columns + pixels) * 1e-3, 1e-9);
    EXPECT_EQ(frame.sentBytes, columns + pixels);
}

TEST(Simulator, StagesAddUpAndFixedCostsDoNotScale)
{
    SimulatedCluster cluster = convolveOnly(4, "static");
    cluster.costs = {
        .projectFixedMs = 3, .projectPixelNs = 1000, .convolvePixelNs = 2000, .shadePixelNs = 500, .coverageMs = 7};
    const SimulatedFrame frame = oneFrame(cluster, uniformRows(400, 100));
    EXPECT_NEAR(frame.projectMs, 3 + 10, 1e-9);
    EXPECT_NEAR(frame.convolveMs, 20, 1e-9);
    EXPECT_NEAR(frame.shadeMs, 50, 1e-9);  // Background too: 100 rows of 1000 pixels.
    EXPECT_EQ(frame.coverageMs, 0);        // Static stripes need none.
    EXPECT_NEAR(frame.totalMs(), 83, 1e-9);
    cluster.balancer = "pixels";
    EXPECT_NEAR(oneFrame(cluster, uniformRows(400, 100)).coverageMs, 7, 1e-9);
}

TEST(Simulator, AThousandRanksOn16KTimes16K)
{
    SimulatedCluster cluster;
    cluster.ranks = 1024;
    cluster.imageWidth = 16384;
    cluster.guardRows = 130;
    cluster.costs = {
        .projectFixedMs = 0.5, .projectPixelNs = 4, .convolvePixelNs = 200, .shadePixelNs = 2, .coverageMs = 0.5};
    const RowCoverage image = uniformRows(16384, 10000);
    SimulatedCluster one = cluster;
    one.ranks = 1;
    const SimulatedFrame many = oneFrame(cluster, image), alone = oneFrame(one, image);
    EXPECT_EQ(many.stripes.ranks(), 1024);
    EXPECT_NEAR(alone.computeMs(), 0.5 + 16384e-6 * (204 * 10000.0 + 2 * 16384), 1e-6);
    EXPECT_NEAR(many.computeMs(), 1.0 + (alone.computeMs() - 0.5) / 1024, 0.1);
    EXPECT_GT(many.gatherNetworkMs, 1e3 * 10000.0 * 16368 * 3 / 12.5e9);  // The picture itself is what remains.
}

TEST(Coarsened, RowsAreMeansOfTheirBlocks)
{
    const RowCoverage fine{7, 1, {10, 20, 30, 40, 50, 60, 100}};
    const RowCoverage coarse = coarsened(fine, 5);
    EXPECT_EQ(coarse.height, 7);
    EXPECT_EQ(coarse.factor, 5);
    EXPECT_EQ(coarse.coveredPerRow, (std::vector<std::int64_t>{6, 16}));  // 150 / 25, 160 / 10.
}

TEST(NetworkModel, SmallCollectivesTakeARoundForEveryDoubling)
{
    const NetworkModel network{1e300, 1000};
    EXPECT_EQ(network.collectiveMs(1, 8), 0);
    EXPECT_EQ(network.collectiveMs(2, 8), 1);
    EXPECT_EQ(network.collectiveMs(5, 8), 3);
    EXPECT_EQ(network.collectiveMs(1024, 8), 10);
}

}  // namespace
}  // namespace aeolic
