#include "reader/binary/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace aeolic {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(ReadReal, NumbersThatNoDoubleHoldsBecomeZeroOrInfinite)
{
    const std::pair<std::string, double> cases[] = {{"1.5", 1.5},      {"-2e3", -2000},     {"1e-330", 0},
                                                    {"-1e-330", -0.0}, {"1e400", kInf},     {"-1e400", -kInf},
                                                    {"1e99999", kInf}, {"-1E99999", -kInf}, {"1e-99999", 0.0},
                                                    {"1E-99999", 0.0}, {"4e-320", 4e-320}};
    for (const auto& [text, expected] : cases) {
        double value = 7;
        const auto [end, error] = readReal(text.data(), text.data() + text.size(), value);
        EXPECT_EQ(error, std::errc{}) << text;
        EXPECT_EQ(end, text.data() + text.size()) << text;
        EXPECT_EQ(value, expected) << text;
        EXPECT_EQ(std::signbit(value), std::signbit(expected)) << text;
    }
}

TEST(ReadReal, WhatIsNoNumberStaysNone)
{
    for (const std::string text : {"", "x", "-", "e5"}) {
        double value = 7;
        EXPECT_EQ(readReal(text.data(), text.data() + text.size(), value).ec, std::errc::invalid_argument) << text;
        EXPECT_EQ(value, 7);
    }
}

}  // namespace
}  // namespace aeolic
