#include "render/coverage_bits.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(CoverageBits, RunsAreCountedAcrossWords)
{
    CoverageBits bits;
    bits.clear(150, 4);
    const auto cover = [&](int y, int x0, int x1) {
        for (int x = x0; x < x1; ++x)
            bits.words[std::size_t(y) * bits.wordsPerRow + std::size_t(x) / 64] |= std::uint64_t{1} << (x % 64);
    };
    cover(0, 10, 140);  // One, through three words.
    cover(1, 0, 1);
    cover(1, 60, 64);
    cover(1, 65, 70);
    cover(1, 128, 150);
    cover(3, 0, 150);
    EXPECT_EQ(bits.runsPerRow(), (std::vector<std::int64_t>{1, 4, 0, 1}));
    EXPECT_EQ(bits.pixelsPerRow(), (std::vector<std::int64_t>{130, 32, 0, 150}));
}

}  // namespace
}  // namespace aeolic
