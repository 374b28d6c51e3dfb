#include "scaling/costs.h"

#include <gtest/gtest.h>

#include <vector>

namespace aeolic {
namespace {

constexpr int kWidth = 100;

/// A rank whose stages take what these costs say. Picoseconds would vanish in the fit: the numbers are of a real
/// frame's size.
RankStats rankOf(int rank, int rows, std::int64_t pixels, std::int64_t guardPixels)
{
    RankStats stats;
    stats.rank = rank;
    stats.rows = rows;
    stats.pixels = pixels;
    stats.guardPixels = guardPixels;
    stats.guardAbove = guardPixels > 0 ? 10 : 0;
    const double area = double(rows) * kWidth, guardArea = double(stats.guardAbove) * kWidth;
    stats.project.busyMs = 0.5 + 4e-6 * double(pixels + guardPixels) + 1e-6 * (area + guardArea);
    stats.convolve.busyMs = 90e-6 * double(guardPixels) + 200e-6 * double(pixels) + 3e-6 * (area + guardArea);
    stats.shade.busyMs = 7e-6 * area;
    stats.gather.busyMs = 5e-6 * double(pixels);
    return stats;
}

TEST(FitCosts, FindsTheCostsThatTheTimesWereMadeOf)
{
    const std::vector<std::vector<RankStats>> frames = {{rankOf(0, 400, 12000, 0)},
                                                        {rankOf(0, 150, 9000, 700), rankOf(1, 250, 3000, 400)},
                                                        {rankOf(0, 90, 2000, 650), rankOf(1, 310, 10000, 300)}};
    const MeasuredCosts costs = fitCosts(frames, kWidth);
    EXPECT_NEAR(costs.projectFixedMs, 0.5, 1e-6);
    EXPECT_NEAR(costs.projectPixelNs, 4, 1e-4);
    EXPECT_NEAR(costs.projectAreaNs, 1, 1e-4);
    EXPECT_NEAR(costs.convolvePixelNs, 200, 1e-3);
    EXPECT_NEAR(costs.convolveGuardPixelNs, 90, 1e-3);
    EXPECT_NEAR(costs.convolveAreaNs, 3, 1e-3);
    EXPECT_NEAR(costs.shadePixelNs, 7, 1e-4);
    EXPECT_NEAR(costs.packPixelNs, 5, 1e-4);
}

/// The best fit would say that a pixel saves time.
TEST(FitCosts, NoCostIsNegative)
{
    RankStats few = rankOf(0, 100, 1000, 0), many = rankOf(0, 100, 2000, 0);
    few.convolve.busyMs = 2;
    many.convolve.busyMs = 1;
    const MeasuredCosts costs = fitCosts(std::vector<std::vector<RankStats>>{{few}, {many}}, kWidth);
    EXPECT_EQ(costs.convolvePixelNs, 0);
    EXPECT_GT(costs.convolveAreaNs, 0);
}

}  // namespace
}  // namespace aeolic
