#include "scaling/scaling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scaling/scaling_report.h"

namespace aeolic {
namespace {

ScalingBenchPlan smallPlan()
{
    ScalingBenchPlan plan;
    plan.scene.surface.spec = "sphere:200";
    plan.scene.field.spec = "rotation:8,8,8";
    plan.scene.output.width = 50;
    plan.scene.output.height = 40;
    plan.scene.output.frames = 2;
    plan.scene.lic.steps = 8;
    plan.ranks = {1, 2, 3};
    plan.balancers = {"static", "pixels"};
    plan.parts = {ScalingPart::nodes, ScalingPart::bricks};
    plan.largeField = "rotation:12,12,12";
    plan.repeats = 1;
    return plan;
}

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Each number of ranks takes minutes: its rows are there before the next is measured, and Table 1 when all are.
TEST(BenchScaling, RowsAreShownAsTheyAreMeasured)
{
    const ScalingBenchPlan plan = smallPlan();
    ScalingTables tables(plan);
    std::vector<std::string> shown;
    std::vector<std::size_t> rows;
    const ScalingBench bench = benchScaling(plan, {.more = [&](const ScalingBench& soFar) {
                                                rows.push_back(soFar.rows.size());
                                                shown.push_back(tables.next(soFar));
                                            }});
    ASSERT_EQ(rows, (std::vector<std::size_t>{0, 1, 3, 5, 5 + 3 * 2}));
    EXPECT_TRUE(has(shown[0], "sphere:200, field rotation:8,8,8, turned")) << shown[0];
    EXPECT_TRUE(has(shown[1], "\n    1 -")) << shown[1];
    EXPECT_EQ(std::count(shown[2].begin(), shown[2].end(), '\n'), 2) << shown[2];
    EXPECT_TRUE(shown[2].starts_with("    2 static ") && has(shown[2], "\n    2 pixels ")) << shown[2];
    EXPECT_TRUE(has(shown[3], "    3 pixels ") && has(shown[3], "Frames per second, modelled")) << shown[3];
    EXPECT_TRUE(has(shown[3], "The ranks of the median frame, pixels, 3 nodes")) << shown[3];
    EXPECT_TRUE(has(shown[4], "rotation:12,12,12, in bricks: ")) << shown[4];
    EXPECT_EQ(tables.next(bench), "") << "everything was shown";
}

TEST(BenchScaling, CostsAreThereWhereNodesAreMeasured)
{
    ScalingBenchPlan plan = smallPlan();
    plan.balancers = {"static"};
    plan.parts = {ScalingPart::bricks};
    const ScalingBench bricks = benchScaling(plan);
    EXPECT_FALSE(bricks.costs || bricks.oneRank() || bricks.steadiness);
    plan.parts = {ScalingPart::nodes};
    plan.ranks = {1, 2};
    const ScalingBench nodes = benchScaling(plan);
    ASSERT_TRUE(nodes.costs && nodes.oneRank());
    // Which term of the fit carries the cost of so small a picture is chance; together they are the time it took.
    EXPECT_GT(nodes.costs->convolvePixelNs + nodes.costs->convolveGuardPixelNs + nodes.costs->convolveAreaNs, 0);
    EXPECT_FALSE(nodes.steadiness) << "one rank was measured beside two ranks only";
}

}  // namespace
}  // namespace aeolic
