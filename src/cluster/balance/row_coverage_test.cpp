#include "cluster/balance/row_coverage.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(RowCoverage, CoarseRowsStandForTheirBlocks)
{
    const RowCoverage fine{7, 1, {10, 20, 30, 40, 50, 60, 100}};
    const RowCoverage coarse = coarsened(fine, 5);
    EXPECT_EQ(coarse.height, 7);
    EXPECT_EQ(coarse.factor, 5);
    EXPECT_EQ(coarse.coveredPerRow, (std::vector<std::int64_t>{6, 16}));  // 150 / 25, 160 / 10.
    const RowSums sums(coarse);
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
