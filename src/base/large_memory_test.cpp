#include "base/large_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace aeolic {

TEST(LargeMemory, HugePagesKeepWhatIsThere)
{
    constexpr std::size_t bytes = std::size_t(9) << 20;
    const auto memory = makeLargeArray<unsigned char>(bytes);
    for (std::size_t i = 0; i < bytes; ++i) memory[i] = static_cast<unsigned char>(i % 251);
    for (const std::size_t begin : {0, 1, 4096, 5 << 20})
        for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(2) << 20, bytes - begin})
            wishForHugePages(memory.get() + begin, std::min(count, bytes - begin));
    for (std::size_t i = 0; i < bytes; ++i) ASSERT_EQ(memory[i], i % 251) << i;
}

TEST(LargeMemory, LargeVectorsHoldTheValueTheyAreMadeWith)
{
    const LargeVector<std::uint32_t> numbers(std::size_t(3) << 20, 7);
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 7u), 3 << 20);
}

}  // namespace aeolic
