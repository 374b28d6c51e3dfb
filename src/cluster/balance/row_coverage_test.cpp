#include "cluster/balance/row_coverage.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ranks/thread_communicator.h"

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

TEST(SharedCoverage, EveryRankGetsWhatAnyCovers)
{
    for (const int ranks : {1, 2, 5})
        runRanks(ranks, [&](Communicator& communicator) {
            CoverageBits bits;
            bits.clear(70, 3);
            EXPECT_EQ(bits.wordsPerRow, 2u);
            bits.words[0] |= 1;                                              // Everyone's.
            bits.words[3] |= std::uint64_t{1} << (communicator.rank() % 6);  // Pixels 64 … 69 of the second row.
            uniteCoverage(communicator, bits);
            EXPECT_EQ(bits.pixelsPerRow(), (std::vector<std::int64_t>{1, ranks, 0}));
        });
}

TEST(SharedCoverage, AnotherSizeIsFoundOut)
{
    EXPECT_THROW(runRanks(2,
                          [](Communicator& communicator) {
                              CoverageBits bits;
                              bits.clear(64, 3 + communicator.rank());
                              uniteCoverage(communicator, bits);
                          }),
                 std::logic_error);
}

}  // namespace
}  // namespace aeolic
