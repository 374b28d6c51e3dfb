#include "engine/legend_place.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(LegendPlace, FramesStandForAllOfAnAnimation)
{
    EXPECT_EQ(sampledFrames(1), std::vector<int>{0});
    EXPECT_EQ(sampledFrames(3), (std::vector<int>{0, 1, 2}));
    const std::vector<int> many = sampledFrames(100000);
    ASSERT_EQ(many.size(), 16u);
    EXPECT_EQ(many[0], 0);
    EXPECT_EQ(many[15], 93750);
}

/// Pixels of a fifth of the resolution that lie only partly in the box count for that part: boxes of the same size that
/// are covered alike count alike, wherever they begin.
TEST(LegendPlace, CoverageIsAnArea)
{
    CoverageBits bits;
    bits.clear(100, 40);
    for (std::uint64_t& word : bits.words) word = ~std::uint64_t{0};
    for (const int x : {0, 3, 247, 385})
        for (const int y : {0, 2, 131}) EXPECT_EQ(coveredArea({x, y, 101, 67}, bits, 5), 101 * 67) << x << " " << y;
    bits.clear(100, 40);
    bits.words[7 * bits.wordsPerRow + 1] = 1;  // The pixel (64, 7) stands for (320 to 325, 35 to 40).
    EXPECT_EQ(coveredArea({300, 20, 100, 100}, bits, 5), 25);
    EXPECT_EQ(coveredArea({323, 39, 100, 100}, bits, 5), 2);
    EXPECT_EQ(coveredArea({325, 20, 100, 100}, bits, 5), 0);
    EXPECT_EQ(coveredArea({300, 20, 22, 16}, bits, 5), 2);
}

}  // namespace
}  // namespace aeolic
