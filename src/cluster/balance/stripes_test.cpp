#include "cluster/balance/stripes.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(Stripes, EqualOnesDifferByAtMostARow)
{
    EXPECT_EQ(equalStripes(800, 8).firstRow, (std::vector<int>{0, 100, 200, 300, 400, 500, 600, 700, 800}));
    for (const int ranks : {1, 3, 7, 13})
        for (int r = 0; r < ranks; ++r) {
            const Stripes stripes = equalStripes(101, ranks);
            EXPECT_GE(stripes.rows(r), 101 / ranks);
            EXPECT_LE(stripes.rows(r), 101 / ranks + 1);
        }
}

TEST(Stripes, ALargeImageOnManyRanksDoesNotOverflow)
{
    const Stripes stripes = equalStripes(32768, 100000);
    EXPECT_EQ(stripes.firstRow.back(), 32768);
    EXPECT_EQ(stripes.firstRow[50000], 16384);
}

TEST(Stripes, EveryRowIsOwnedByTheStripeThatHoldsIt)
{
    const Stripes stripes{{0, 0, 3, 3, 3, 7, 7}};  // Empty stripes first, in the middle and last.
    for (int row = 0; row < 7; ++row) {
        const Extent extent = stripes.extent(stripes.ownerOf(row), 5);
        EXPECT_TRUE(extent.contains(4, row)) << row;
    }
    EXPECT_EQ(stripes.ownerOf(0), 1);
    EXPECT_EQ(stripes.ownerOf(3), 4);
    EXPECT_EQ(stripes.ranks(), 6);
    EXPECT_EQ(stripes.height(), 7);
}

TEST(GuardRows, OnlyWhereThereIsANeighbour)
{
    const Stripes stripes = equalStripes(30, 3);
    EXPECT_EQ(withGuard(stripes.extent(0, 9), {4, 4}, 30), (Extent{0, 0, 9, 14}));
    EXPECT_EQ(withGuard(stripes.extent(1, 9), {4, 2}, 30), (Extent{0, 6, 9, 22}));
    EXPECT_EQ(withGuard(stripes.extent(2, 9), {4, 4}, 30), (Extent{0, 16, 9, 30}));
}

TEST(GuardRows, MayReachPastNeighboursToTheImagesEnd)
{
    EXPECT_EQ(withGuard({0, 10, 9, 11}, {100, 100}, 30), (Extent{0, 0, 9, 30}));
}

TEST(GuardRows, AnEmptyStripeHasNone)
{
    EXPECT_TRUE(withGuard({0, 10, 9, 10}, {4, 4}, 30).empty());
}

}  // namespace
}  // namespace aeolic
