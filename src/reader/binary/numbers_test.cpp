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
    const std::pair<std::string, double> cases[] = {
        {"1.5", 1.5},       {"-2e3", -2000},   {"1e-330", 0},       {"-1e-330", -0.0},  {"1e400", kInf},
        {"-1e400", -kInf},  {"1e99999", kInf}, {"-1E99999", -kInf}, {"1e-99999", 0.0},  {"1E-99999", 0.0},
        {"4e-320", 4e-320}, {"+1.5", 1.5},     {"1D-3", 1e-3},      {"-2.5d+02", -250}, {"0.4-102", 0.4e-102},
        {"1.+300", 1e300},  {"7D400", kInf},   {"0.4-400", 0.0}};
    for (const auto& [text, expected] : cases) {
        double value = 7;
        const auto [end, error] = readReal(text.data(), text.data() + text.size(), value);
        EXPECT_EQ(error, std::errc{}) << text;
        EXPECT_EQ(end, text.data() + text.size()) << text;
        EXPECT_EQ(value, expected) << text;
        EXPECT_EQ(std::signbit(value), std::signbit(expected)) << text;
    }
}

TEST(ReadReal, ANumberEndsWhereNoExponentFollows)
{
    for (const std::string text : {"1,5", "1d", "1-", "1e", "1+x", "1 2", "3*2", "1e2-3", "inf-3", "1-2", "5-1234"}) {
        double value = 7;
        const auto [end, error] = readReal(text.data(), text.data() + text.size(), value);
        EXPECT_EQ(error, std::errc{}) << text;
        EXPECT_EQ(end - text.data(), text.ends_with("-3") ? 3 : 1) << text;
    }
}

TEST(ReadReal, AFloatIsRoundedOnce)
{
    const std::string text = "1.00000017881393432617187499";  // As a double it lies between two floats.
    float value = 0;
    readReal(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(value, 1.00000011920928955078125F);
}

TEST(ReadReal, WhatIsNoNumberStaysNone)
{
    for (const std::string text : {"", "x", "-", "e5", "+", "+-1", "d5"}) {
        double value = 7;
        EXPECT_EQ(readReal(text.data(), text.data() + text.size(), value).ec, std::errc::invalid_argument) << text;
        EXPECT_EQ(value, 7);
    }
}

}  // namespace
}  // namespace aeolic
