#include "render/lic/near_flow.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(FlowColumns, FirstToLastOfARow)
{
    std::vector<std::uint32_t> row(100, 0);
    EXPECT_TRUE(flowColumns(row.data(), 0, 100).empty());
    row[40] = 1;
    EXPECT_EQ(flowColumns(row.data(), 0, 100), (ColumnSpan{40, 41}));
    row[99] = 1;
    EXPECT_EQ(flowColumns(row.data(), 0, 100), (ColumnSpan{40, 100}));
    EXPECT_EQ(flowColumns(row.data(), 0, 99), (ColumnSpan{40, 41}));
    row[0] = 1;
    EXPECT_EQ(flowColumns(row.data(), 0, 100), (ColumnSpan{0, 100}));
    EXPECT_EQ(flowColumns(row.data(), 1, 2), ColumnSpan{});
    EXPECT_EQ(flowColumns(row.data(), 5, 5), ColumnSpan{});
}

TEST(NearFlow, ReachesAStepAndAVectorFurther)
{
    const Extent rows{0, 100, 500, 150};
    std::vector<ColumnSpan> flow(50);
    flow[20] = {203, 210};
    flow[22] = {300, 305};
    const NearFlow near(rows, flow);
    EXPECT_TRUE(near.at(109).empty());
    EXPECT_EQ(near.at(110), (ColumnSpan{176, 226}));  // 203 - 16 is in the block that begins at 176.
    EXPECT_EQ(near.at(112), (ColumnSpan{176, 321}));
    EXPECT_EQ(near.at(130), (ColumnSpan{176, 321}));
    EXPECT_EQ(near.at(132), (ColumnSpan{272, 321}));
    EXPECT_TRUE(near.at(133).empty());
}

TEST(NearFlow, EndsWhereTheImageEnds)
{
    const NearFlow near({0, 0, 40, 3}, {{}, {2, 39}, {}});
    for (int y = 0; y < 3; ++y) EXPECT_EQ(near.at(y), (ColumnSpan{0, 40}));
}

}  // namespace
}  // namespace aeolic
