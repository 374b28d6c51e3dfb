#include "description/colormap.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"

namespace aeolic {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

TEST(ColorMap, EndsAreThePublishedOnes)
{
    EXPECT_EQ(colorMap("viridis").front(), (Rgb{68, 1, 84}));
    EXPECT_EQ(colorMap("viridis").back(), (Rgb{253, 231, 37}));
    EXPECT_EQ(colorMap("coolwarm").front(), (Rgb{59, 76, 192}));
    EXPECT_EQ(colorMap("coolwarm").back(), (Rgb{180, 4, 38}));
    EXPECT_EQ(colorMap("turbo").front(), (Rgb{48, 18, 59}));
    EXPECT_EQ(colorMap("cividis").front(), (Rgb{0, 34, 78}));
    EXPECT_EQ(colorMap("RdBu").front(), (Rgb{103, 0, 31}));
    EXPECT_EQ(colorMap("RdBu").back(), (Rgb{5, 48, 97}));
    EXPECT_EQ(colorMap("vik").front(), (Rgb{0, 18, 97}));
    EXPECT_EQ(colorMap("vik").back(), (Rgb{89, 0, 8}));
    for (int i = 0; i < 256; ++i) EXPECT_EQ(colorMap("gray")[std::size_t(i)][1], i);
}

TEST(ColorMap, DivergingMiddleIsNeutral)
{
    const Rgb middle = colorMap("coolwarm")[128];
    EXPECT_NEAR(middle[0], 221, 2);
    EXPECT_NEAR(middle[1], 221, 2);
    EXPECT_NEAR(middle[2], 221, 2);
}

/// These maps are perceptual: lightness never falls. Luma stands in for lightness.
TEST(ColorMap, SequentialMapsOnlyGetLighter)
{
    for (const char* name : {"viridis", "gray", "plasma", "inferno", "magma", "cividis"}) {
        const ColorTable& table = colorMap(name);
        const auto luma = [&](std::size_t i) {
            return 0.2126 * table[i][0] + 0.7152 * table[i][1] + 0.0722 * table[i][2];
        };
        for (std::size_t i = 1; i < 256; ++i) EXPECT_GT(luma(i), luma(i - 1) - 0.8) << name << " " << i;
        EXPECT_GT(luma(255), luma(0) + 100) << name;
    }
}

TEST(ColorMap, CyclicMapsEndWhereTheyBegin)
{
    EXPECT_EQ(colorMap("twilight").front(), colorMap("twilight").back());
}

TEST(ColorMap, FilesAreKnownByTheirEndings)
{
    for (const char* name : {"a.json", "b.XML", "/c/d.csv", "viridis.json"}) EXPECT_TRUE(isColorMapFile(name)) << name;
    for (const char* name : {"viridis", ".json", "a/.csv", "a.json.txt", "", "json"})
        EXPECT_FALSE(isColorMapFile(name)) << name;
}

TEST(ColorMap, NeighboursNeverJump)
{
    for (const std::string_view name : colorMapNames())
        for (std::size_t i = 1; i < 256; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_LE(std::abs(colorMap(name)[i][c] - colorMap(name)[i - 1][c]), 8) << name << " " << i;
}

TEST(ColorMap, UnknownNameListsTheKnownOnes)
{
    try {
        colorMap("jet");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "colour map: found 'jet'; expected one of viridis, turbo, coolwarm, gray, plasma, inferno, magma, "
                     "cividis, twilight, RdBu, vik");
    }
}

}  // namespace
}  // namespace aeolic
