#include "render/overlay/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace aeolic {
namespace {

using Labels = std::vector<std::string>;

TEST(Ticks, KnownRanges)
{
    EXPECT_EQ(niceTicks(0, 1, 7).labels, (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(niceTicks(0, 1, 7).values, (std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1}));
    EXPECT_EQ(niceTicks(-1400, 800, 7).labels, (Labels{"−1000", "−500", "0", "500"}));
    EXPECT_EQ(niceTicks(-1, 1, 3).labels, (Labels{"−1", "0", "1"}));
    EXPECT_EQ(niceTicks(101325, 101327.3, 6).labels,
              (Labels{"101325.0", "101325.5", "101326.0", "101326.5", "101327.0"}));
}

TEST(Ticks, SmallAndLargeValuesShareAFactor)
{
    const Ticks small = niceTicks(1e-7, 3e-7, 7);
    EXPECT_EQ(small.factor, "×10⁻⁷");
    EXPECT_EQ(small.labels, (Labels{"1.0", "1.5", "2.0", "2.5", "3.0"}));
    const Ticks large = niceTicks(-2.5e8, 9e12, 7);
    EXPECT_EQ(large.factor, "×10¹²");
    EXPECT_EQ(large.labels.back(), "8");
}

TEST(Ticks, EqualEndsGiveOneTick)
{
    EXPECT_EQ(niceTicks(5, 5, 7).labels, Labels{"5"});
    EXPECT_EQ(niceTicks(0, 0, 7).labels, Labels{"0"});
    EXPECT_EQ(niceTicks(-0.0, 0.0, 7).labels, Labels{"0"});
    const Ticks tiny = niceTicks(-2.5e-9, -2.5e-9, 7);
    EXPECT_EQ(tiny.labels, Labels{"−2.5"});
    EXPECT_EQ(tiny.factor, "×10⁻⁹");
}

TEST(Ticks, OverflowingAndDenormalRanges)
{
    EXPECT_GE(niceTicks(-1.7e308, 1.7e308, 7).values.size(), 2u);
    EXPECT_GE(niceTicks(0, 5e-324, 7).values.size(), 1u);
    EXPECT_GE(niceTicks(0, 1e-310, 7).values.size(), 1u);
    EXPECT_EQ(niceTicks(1e15, 1e15 + 1, 7).values.size(), 1u);
}

TEST(Ticks, AnyRangeGivesAFewAscendingDistinctTicksWithinIt)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-30, 30), mantissa(-1, 1);
    for (int i = 0; i < 20000; ++i) {
        double lo = mantissa(random) * std::pow(10, exponent(random)),
               hi = mantissa(random) * std::pow(10, exponent(random));
        if (lo > hi) std::swap(lo, hi);
        const int most = 2 + i % 6;
        const Ticks ticks = niceTicks(lo, hi, most);
        ASSERT_GE(ticks.values.size(), 1u) << lo << " " << hi;
        ASSERT_LE(ticks.values.size(), std::size_t(most)) << lo << " " << hi;
        ASSERT_EQ(ticks.values.size(), ticks.labels.size());
        ASSERT_GE(ticks.values.front(), lo);
        ASSERT_LE(ticks.values.back(), hi);
        for (std::size_t k = 1; k < ticks.values.size(); ++k) {
            ASSERT_LT(ticks.values[k - 1], ticks.values[k]) << lo << " " << hi;
            ASSERT_NE(ticks.labels[k - 1], ticks.labels[k]) << lo << " " << hi;
        }
    }
}

TEST(LogTicks, ArePowersOfTenWhereThereAreEnough)
{
    EXPECT_EQ(logTicks(1e-3, 10, 7).labels, (std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10"}));
    EXPECT_EQ(logTicks(1e-9, 1e-6, 7).labels, (std::vector<std::string>{"10⁻⁹", "10⁻⁸", "10⁻⁷", "10⁻⁶"}));
    EXPECT_LE(logTicks(1e-30, 1e30, 7).values.size(), 7u);
    EXPECT_GE(logTicks(1e-30, 1e30, 7).values.size(), 3u);
}

TEST(LogTicks, NarrowRangesGetOtherMultiples)
{
    EXPECT_EQ(logTicks(1, 10, 7).labels, (std::vector<std::string>{"1", "2", "5", "10"}));
    EXPECT_EQ(logTicks(0.1, 3, 7).labels, (std::vector<std::string>{"0.1", "0.2", "0.5", "1", "2"}));
    const Ticks narrow = logTicks(3.1, 3.4, 5);
    EXPECT_GE(narrow.values.size(), 2u);
    for (const double value : narrow.values) EXPECT_TRUE(value >= 3.1 && value <= 3.4) << value;
}

TEST(LogTicks, AllStayWithinAndAscend)
{
    for (const auto& [lo, hi] : {std::pair{1e-300, 1e300}, {5e-324, 1e-300}, {0.999999, 1.0000001}, {1e-7, 2e5}}) {
        const Ticks ticks = logTicks(lo, hi, 7);
        ASSERT_EQ(ticks.values.size(), ticks.labels.size());
        EXPECT_LE(ticks.values.size(), 8u);
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
            EXPECT_TRUE(ticks.values[i] >= lo && ticks.values[i] <= hi) << lo << " " << hi;
            if (i > 0) {
                EXPECT_LT(ticks.values[i - 1], ticks.values[i]);
            }
        }
    }
}

TEST(BandTicks, StandAtTheEdges)
{
    EXPECT_EQ(bandTicks(0, 1, 4, 7).labels, (std::vector<std::string>{"0", "0.25", "0.5", "0.75", "1"}));
    EXPECT_EQ(bandTicks(-1, 1, 8, 4).labels, (std::vector<std::string>{"−1", "−0.5", "0", "0.5", "1"}));
    EXPECT_EQ(bandTicks(-0.3, 0.3, 2, 7).labels[1], "0");
    EXPECT_EQ(bandTicks(0, 30000, 3, 7).labels, (std::vector<std::string>{"0", "10000", "20000", "30000"}));
    EXPECT_LE(bandTicks(0, 1, 256, 7).values.size(), 8u);
}

/// 11 and 13 are prime: no step but 1 ends at the upper edge.
TEST(BandTicks, BothEndsHaveOne)
{
    EXPECT_EQ(bandTicks(0, 9, 9, 7).values, (std::vector<double>{0, 3, 6, 9}))
        << "every third rather than every second";
    EXPECT_EQ(bandTicks(0, 11, 11, 7).values, (std::vector<double>{0, 2, 4, 6, 8, 11}));
    EXPECT_EQ(bandTicks(0, 13, 13, 7).values, (std::vector<double>{0, 2, 4, 6, 8, 10, 13}));
    EXPECT_EQ(bandTicks(0, 5, 5, 3).values, (std::vector<double>{0, 2, 5}));
}

TEST(BandTicks, KeepTheirDistanceWhateverTheNumberOfBands)
{
    for (int most = 2; most <= 7; ++most)
        for (int bands = 2; bands <= 256; ++bands) {
            const std::vector<double> values = bandTicks(0, bands, bands, most).values;
            ASSERT_GE(values.size(), 2u);
            ASSERT_LE(values.size(), std::size_t(most) + 1);
            EXPECT_EQ(values.front(), 0);
            EXPECT_EQ(values.back(), bands);
            const double step = values[1] - values[0];
            EXPECT_GE(step, double(bands) / most - 1e-9) << bands << " bands";
            for (std::size_t i = 1; i < values.size(); ++i) {
                const double gap = values[i] - values[i - 1];
                if (i + 1 < values.size()) {
                    EXPECT_NEAR(gap, step, 1e-9) << bands << " bands";
                }
                EXPECT_GE(gap, step - 1e-9) << bands << " bands";
                EXPECT_LT(gap, 2 * step) << bands << " bands";
            }
        }
}

TEST(BandTicks, TellNarrowBandsApart)
{
    EXPECT_EQ(bandTicks(293.15, 293.16, 4, 7).labels,
              (std::vector<std::string>{"293.15", "293.1525", "293.155", "293.1575", "293.16"}));
    EXPECT_EQ(bandTicks(101300, 101350, 4, 7).labels,
              (std::vector<std::string>{"101300", "101312.5", "101325", "101337.5", "101350"}));
    EXPECT_EQ(bandTicks(0, 1, 3, 7).labels, (std::vector<std::string>{"0", "0.3333", "0.6667", "1"}));
    EXPECT_GE(bandTicks(1, 1 + 1e-15, 4, 7).labels.size(), 2u);
    EXPECT_GE(bandTicks(0, 1e-310, 4, 7).labels.size(), 2u);
    EXPECT_GE(bandTicks(-1e37, 1e37, 4, 7).labels.size(), 2u);
}

}  // namespace
}  // namespace aeolic
