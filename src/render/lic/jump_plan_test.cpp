#include "render/lic/jump_plan.h"

#include <gtest/gtest.h>

#include "render/limits.h"

namespace aeolic {
namespace {

TEST(JumpPlan, AddsUpToExactlyTheStepsAsked)
{
    for (int steps = 1; steps <= 400; ++steps) {
        const JumpPlan plan = planJumps(steps);
        EXPECT_EQ(plan.steps(), steps);
        EXPECT_GE(plan.remainder, 0);
        EXPECT_LT(plan.remainder, plan.direct);
        EXPECT_EQ(plan.digits.size(), plan.radix.size() + 1);
        EXPECT_GT(plan.digits.back(), 0) << steps << ": the top level must be of use";
    }
    for (const int steps : {1000, 1024, 4096, 65535, 65536}) EXPECT_EQ(planJumps(steps).steps(), steps);
}

TEST(JumpPlan, EightDirectStepsThenFourTimesFour)
{
    const JumpPlan plan = planJumps(128);
    EXPECT_EQ(plan.direct, 8);
    EXPECT_EQ(plan.radix, std::vector<int>{4});
    EXPECT_EQ(plan.digits, (std::vector<int>{0, 4}));
    EXPECT_EQ(plan.lookups(), 6);
}

TEST(JumpPlan, JumpsAreLookedUpWhereTheLastOneStarts)
{
    const JumpPlan plan = planJumps(128);  // 4 jumps of 32, each 4 of 8.
    EXPECT_EQ(plan.levelReach(0), 24);
    EXPECT_EQ(plan.levelReach(1), 96);
    EXPECT_EQ(plan.linkReach(0), 32) << "to the end of a jump of the second level";
    EXPECT_EQ(plan.linkReach(1), 96);
    for (int steps = 1; steps <= 400; ++steps) {
        const JumpPlan any = planJumps(steps);
        for (std::size_t level = 0; level < any.digits.size(); ++level)
            EXPECT_LE(any.levelReach(level), steps - any.stride(level)) << steps;
        EXPECT_EQ(any.remainderReach(), steps - any.remainder);
        for (std::size_t level = 0; level < any.digits.size(); ++level)
            EXPECT_GE(any.linkReach(level), any.levelReach(level)) << steps;
        if (any.remainder > 0) {
            EXPECT_GE(any.linkReach(0), any.remainderReach()) << steps;
        }
    }
}

TEST(JumpPlan, LookupsGrowWithTheLogarithm)
{
    const int few = planJumps(128).lookups(), many = planJumps(65536).lookups();
    EXPECT_LE(many, 4 * few);
    EXPECT_LE(planJumps(1024).lookups(), 2 * few);
}

TEST(JumpPlan, FewerStepsThanAreWalkedDirectlyNeedNoJump)
{
    for (int steps = 1; steps < 8; ++steps) {
        const JumpPlan plan = planJumps(steps);
        EXPECT_EQ(plan.direct, steps);
        EXPECT_EQ(plan.lookups(), 0);
    }
}

TEST(GuardRows, BoundIsTheWholeTraceItsRoundingAndTheTaps)
{
    EXPECT_EQ(guardRowsBound(128, 1.0, 0), 128 + 1 + limits::kTapRows);
    EXPECT_EQ(guardRowsBound(128, 1.0, 2), 128 + 1 + 2 + limits::kTapRows);
    EXPECT_EQ(guardRowsBound(10, 0.25, 0), 3 + limits::kTapRows);  // 2.5 rows, rounded up.
    EXPECT_EQ(guardRowsBound(65536, 8.0, 0), 524288 + 1024 + limits::kTapRows);
}

}  // namespace
}  // namespace aeolic
