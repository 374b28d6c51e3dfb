#include "cluster/guards/guard_estimate.h"
#include "render/lic/jump_plan.h"
#include "render/limits.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

constexpr double kUnitPx = 1.0 / 2048, kMaxStepPx = 1;
constexpr int kQuarter = 510;  // Units of a quarter pixel a step, once what rounding may add is added.

/// Rows of one pixel, all with flow of so many units up or down.
std::vector<RowFlow> rowsOf(int count, int units)
{
    return std::vector<RowFlow>(std::size_t(count), RowFlow{0, 1, std::uint16_t(units)});
}

GuardRows reachOf(const std::vector<RowFlow>& facts, const Extent& stripe, int steps, int levels = 0)
{
    return VectorReach(facts, kUnitPx, kMaxStepPx, levels).rows(stripe, steps);
}

TEST(BoundReach, IsTheLongestStepTimesTheStepsOnBothSides)
{
    EXPECT_EQ(BoundReach(1.5).rows({0, 40, 9, 50}, 100), (GuardRows{151 + limits::kTapRows, 151 + limits::kTapRows}))
        << "and a row of rounding";
}

TEST(VectorReach, OfUniformFlowIsStepsTimesItsSpeed)
{
    for (const int steps : {4, 40, 100}) {
        const int rows = steps / 4 + limits::kTapRows;
        for (const int levels : {0, 3})
            EXPECT_EQ(reachOf(rowsOf(400, kQuarter), {0, 180, 9, 220}, steps, levels), (GuardRows{rows, rows}))
                << steps;
    }
}

TEST(VectorReach, AtFullSpeedIsTheWorstCase)
{
    for (const int steps : {10, 100, 1000})
        EXPECT_EQ(reachOf(rowsOf(4000, 2047), {0, 1800, 9, 2200}, steps), BoundReach(kMaxStepPx).rows({}, steps));
}

TEST(VectorReach, WhereNothingFlowsOnlyTheTapsAreLeft)
{
    const std::vector<RowFlow> nothing(400);
    EXPECT_EQ(reachOf(nothing, {0, 180, 9, 220}, 1000), (GuardRows{limits::kTapRows, limits::kTapRows}));
}

TEST(VectorReach, FlowAlongRowsLeavesThemByRounding)
{
    EXPECT_EQ(reachOf(rowsOf(400, 0), {0, 180, 9, 220}, 128), (GuardRows{1 + limits::kTapRows, 1 + limits::kTapRows}));
    EXPECT_EQ(reachOf(rowsOf(400, 0), {0, 180, 9, 220}, 3 * 2048),
              (GuardRows{3 + limits::kTapRows, 3 + limits::kTapRows}));
}

TEST(VectorReach, EndsAtAGapThatNoStepCanCross)
{
    std::vector<RowFlow> facts = rowsOf(400, 2047);
    for (std::size_t y = 230; y < 260; ++y) facts[y] = {};
    const GuardRows rows = reachOf(facts, {0, 180, 9, 220}, 100);
    EXPECT_GE(rows.below, 10 + limits::kTapRows);
    EXPECT_LT(rows.below, 20 + limits::kTapRows);
    EXPECT_EQ(rows.above, guardRowsBound(100, kMaxStepPx, 0));
}

TEST(VectorReach, ANarrowGapMayBeSteppedOver)
{
    std::vector<RowFlow> facts = rowsOf(400, 2047);
    facts[225] = facts[226] = {};
    EXPECT_EQ(reachOf(facts, {0, 180, 9, 220}, 100).below, guardRowsBound(100, kMaxStepPx, 0));
}

TEST(VectorReach, SlowRowsHoldATraceBackAndFastOnesBeyondThemCarryItOn)
{
    std::vector<RowFlow> facts = rowsOf(400, kQuarter);  // 40 rows of these take 160 steps.
    for (std::size_t y = 260; y < 400; ++y) facts[y].maxUnits = 2047;
    const auto below = [&](int steps) { return reachOf(facts, {0, 180, 9, 220}, steps).below; };
    EXPECT_EQ(below(100), 25 + limits::kTapRows);
    EXPECT_GE(below(200), 40 + 40 + limits::kTapRows);
    EXPECT_LE(below(200), 40 + 40 + 20 + limits::kTapRows) << "40 slow rows take 160 steps, less some rows of slack";
}

TEST(VectorReach, AtTheImagesEndsThereIsNothingToReach)
{
    const GuardRows rows = reachOf(rowsOf(50, 2047), {0, 0, 9, 50}, 100);
    EXPECT_EQ(rows, (GuardRows{limits::kTapRows, limits::kTapRows})) << "withGuard() leaves those away";
}

}  // namespace
}  // namespace aeolic
