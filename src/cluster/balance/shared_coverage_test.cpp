#include "cluster/balance/shared_coverage.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

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
