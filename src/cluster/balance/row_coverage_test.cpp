#include "cluster/balance/row_coverage.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(RowCoverage, CoarseRowsStandForTheirBlocks)
{
    const RowSums sums({7, 5, {6, 16}});
    EXPECT_EQ(sums.pixels(0, 5), 150);
    EXPECT_EQ(sums.pixels(5, 7), 160);
    EXPECT_EQ(sums.pixels(-9, 99), 310);
    EXPECT_EQ(sums.pixels(6, 2), 0);
    EXPECT_EQ(sums.runs(0, 7), 0) << "not known";
}

TEST(RowCoverage, RunsAreThoseOfEachRowACoarseOneStandsFor)
{
    const RowSums sums({7, 5, {6, 16}, {2, 1}});
    EXPECT_EQ(sums.runs(0, 5), 10);
    EXPECT_EQ(sums.runs(4, 6), 3);
    EXPECT_EQ(sums.runs(-9, 99), 12);
    EXPECT_EQ(ownCost(sums, {0, 0, 3, 0, 7}, 5, 7), 160 + 2 * 3 + 2 * 7);
}

}  // namespace
}  // namespace aeolic
