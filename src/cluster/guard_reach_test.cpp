#include "cluster/guard_reach.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

constexpr double kUnitPx = 1.0 / 2048, kMaxStepPx = 1;
constexpr int kQuarter = 511;  // Units of a quarter pixel a step, once one is added for rounding.

/// Rows of one pixel, all with flow of so many units up or down.
std::vector<RowFacts> rowsOf(int count, int units)
{
    return std::vector<RowFacts>(std::size_t(count), RowFacts{0, 1, std::uint16_t(units)});
}

GuardRows reachOf(const std::vector<RowFacts>& facts, const Extent& stripe, int steps, int levels = 0)
{
    return VectorReach(facts, kUnitPx, kMaxStepPx, levels).rows(stripe, steps);
}

TEST(BoundReach, IsTheLongestStepTimesTheStepsOnBothSides)
{
    const int rows = guardRowsBound(100, 1.5);
    EXPECT_EQ(BoundReach(1.5).rows({0, 40, 9, 50}, 100), (GuardRows{rows, rows}));
}

TEST(VectorReach, OfUniformFlowIsStepsTimesItsSpeed)
{
    for (const int steps : {4, 40, 100}) {
        const int rows = steps / 4 + kTapRows;
        for (const int levels : {0, 3})
            EXPECT_EQ(reachOf(rowsOf(400, kQuarter), {0, 180, 9, 220}, steps, levels), (GuardRows{rows, rows}))
                << steps;
    }
}

TEST(VectorReach, AtFullSpeedIsTheWorstCase)
{
    EXPECT_EQ(reachOf(rowsOf(400, 2047), {0, 180, 9, 220}, 100), (GuardRows{100 + kTapRows, 100 + kTapRows}));
    EXPECT_EQ(reachOf(rowsOf(400, 4000), {0, 180, 9, 220}, 100), BoundReach(kMaxStepPx).rows({}, 100))
        << "never more than that";
}

TEST(VectorReach, WhereNothingFlowsOnlyTheTapsAreLeft)
{
    const std::vector<RowFacts> nothing(400);
    EXPECT_EQ(reachOf(nothing, {0, 180, 9, 220}, 1000), (GuardRows{kTapRows, kTapRows}));
    EXPECT_EQ(reachOf(rowsOf(400, 0), {0, 180, 9, 220}, 1000), (GuardRows{kTapRows, kTapRows}))
        << "flow along the rows";
}

TEST(VectorReach, EndsAtAGapThatNoStepCanCross)
{
    std::vector<RowFacts> facts = rowsOf(400, 2047);
    for (std::size_t y = 230; y < 260; ++y) facts[y] = {};
    const GuardRows rows = reachOf(facts, {0, 180, 9, 220}, 100);
    EXPECT_GE(rows.below, 10 + kTapRows);
    EXPECT_LT(rows.below, 20 + kTapRows);
    EXPECT_EQ(rows.above, 100 + kTapRows);
}

TEST(VectorReach, ANarrowGapMayBeSteppedOver)
{
    std::vector<RowFacts> facts = rowsOf(400, 2047);
    facts[225] = facts[226] = {};
    EXPECT_EQ(reachOf(facts, {0, 180, 9, 220}, 100).below, 100 + kTapRows);
}

TEST(VectorReach, SlowRowsHoldATraceBackAndFastOnesBeyondThemCarryItOn)
{
    std::vector<RowFacts> facts = rowsOf(400, kQuarter);  // 40 rows of these take 160 steps …
    for (std::size_t y = 260; y < 400; ++y) facts[y].maxUnits = 2047;
    const auto below = [&](int steps) { return reachOf(facts, {0, 180, 9, 220}, steps).below; };
    EXPECT_EQ(below(100), 25 + kTapRows);
    EXPECT_GE(below(200), 40 + 40 + kTapRows);
    EXPECT_LE(below(200), 40 + 40 + 20 + kTapRows) << "… less some rows of slack";
}

TEST(VectorReach, AtTheImagesEndsThereIsNothingToReach)
{
    const GuardRows rows = reachOf(rowsOf(50, 2047), {0, 0, 9, 50}, 100);
    EXPECT_EQ(rows, (GuardRows{kTapRows, kTapRows})) << "withGuard() leaves those away";
}

}  // namespace
}  // namespace aeolic
