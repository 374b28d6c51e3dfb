#include "base/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace aeolic {
namespace {

TEST(Half, KnownValues)
{
    EXPECT_EQ(halfFromFloat(0.0f), 0x0000);
    EXPECT_EQ(halfFromFloat(-0.0f), 0x8000);
    EXPECT_EQ(halfFromFloat(1.0f), 0x3c00);
    EXPECT_EQ(halfFromFloat(-2.0f), 0xc000);
    EXPECT_EQ(halfFromFloat(65504.0f), 0x7bff);
    EXPECT_EQ(halfFromFloat(0x1p-14f), 0x0400);
    EXPECT_EQ(halfFromFloat(0x1p-24f), 0x0001);
    EXPECT_EQ(halfFromFloat(0.333333343f), 0x3555);
    EXPECT_EQ(halfFromFloat(std::numeric_limits<float>::infinity()), 0x7c00);
    EXPECT_EQ(halfFromFloat(65520.0f), 0x7c00) << "halfway above the largest half rounds to infinity";
    EXPECT_EQ(halfFromFloat(std::nextafter(65520.0f, 0.0f)), 0x7bff);
    EXPECT_TRUE(std::isnan(floatFromHalf(halfFromFloat(std::numeric_limits<float>::quiet_NaN()))));
}

TEST(Half, TiesGoToEven)
{
    EXPECT_EQ(halfFromFloat(1.0f + 0x1p-11f), 0x3c00);
    EXPECT_EQ(halfFromFloat(1.0f + 0x3p-11f), 0x3c02);
    EXPECT_EQ(halfFromFloat(1.0f + 0x1p-11f + 0x1p-20f), 0x3c01) << "just above the tie";
    EXPECT_EQ(halfFromFloat(0x1p-25f), 0x0000) << "a tie below the smallest subnormal";
    EXPECT_EQ(halfFromFloat(0x3p-25f), 0x0002);
    EXPECT_EQ(halfFromFloat(std::nextafter(0x1p-25f, 1.0f)), 0x0001);
}

TEST(Half, EveryHalfSurvivesTheRoundTrip)
{
    for (std::uint32_t bits = 0; bits < 0x10000u; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        if ((bits & 0x7fffu) > 0x7c00u)
            EXPECT_TRUE(std::isnan(floatFromHalf(half)));
        else
            ASSERT_EQ(halfFromFloat(floatFromHalf(half)), half) << bits;
    }
}

TEST(Half, RoundsToTheNearestOfItsNeighbours)
{
    for (std::uint16_t half = 0; half < 0x7bff; ++half) {
        const double lo = floatFromHalf(half), hi = floatFromHalf(half + 1);
        const auto quarter = static_cast<float>(lo + 0.25 * (hi - lo)),
                   threeQuarters = static_cast<float>(lo + 0.75 * (hi - lo));
        ASSERT_EQ(halfFromFloat(quarter), half);
        ASSERT_EQ(halfFromFloat(threeQuarters), half + 1);
    }
}

TEST(Half, OverflowIsClampedAndCountedInfinityIsMasked)
{
    const std::vector<float> floats{70000.0f, -1e30f, std::numeric_limits<float>::infinity(), 3.0f};
    std::vector<std::uint16_t> halves(floats.size());
    EXPECT_EQ(halvesFromFloatsParallel(floats.data(), halves.data(), floats.size()), 2u);
    EXPECT_EQ(floatFromHalf(halves[0]), 65504.0f);
    EXPECT_EQ(floatFromHalf(halves[1]), -65504.0f);
    EXPECT_TRUE(std::isnan(floatFromHalf(halves[2])));
    EXPECT_EQ(floatFromHalf(halves[3]), 3.0f);
}

TEST(Half, InPlaceEqualsOutOfPlaceAtAwkwardSizes)
{
    for (const std::size_t count : {0ul, 1ul, 65535ul, 65536ul, 65537ul, 300001ul}) {
        std::vector<float> floats(count);
        for (std::size_t i = 0; i < count; ++i)
            floats[i] = std::sin(0.37f * static_cast<float>(i)) * static_cast<float>(i % 1000);
        std::vector<std::uint16_t> expected(count);
        halvesFromFloatsParallel(floats.data(), expected.data(), count);
        convertToHalvesInPlace(floats.data(), count);
        std::vector<std::uint16_t> halves(count);
        if (count > 0) std::memcpy(halves.data(), floats.data(), 2 * count);
        EXPECT_EQ(halves, expected) << count;
    }
}

}  // namespace
}  // namespace aeolic
