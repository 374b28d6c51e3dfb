#include "render/overlay/title_lines.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

using Lines = std::vector<std::string>;

/// In a line as wide as `widest`.
Lines lines(const std::string& title, const std::string& widest)
{
    const TextPainter text(16);
    return titleLines(title, text.widthPx(widest) + 0.1, text);
}

TEST(TitleLines, OneWhereItFits)
{
    EXPECT_EQ(lines("wall shear stress [Pa]", "wall shear stress [Pa]"), Lines{"wall shear stress [Pa]"});
    EXPECT_EQ(lines("", "wide"), Lines{});
    EXPECT_EQ(lines("title", ""), Lines{}) << "no room";
}

TEST(TitleLines, TwoWhereOneIsTooNarrow)
{
    EXPECT_EQ(lines("wall shear stress magnitude [Pa]", "wall shear stress magn"),
              (Lines{"wall shear stress", "magnitude [Pa]"}));
    EXPECT_EQ(lines("a  wide   gap", "a  wide"), (Lines{"a  wide", "gap"}));
}

TEST(TitleLines, AUnitIsNotBroken)
{
    EXPECT_EQ(lines("conductivity [W / (m K)]", "[W / (m K)] ii"), (Lines{"conductivity", "[W / (m K)]"}));
    EXPECT_EQ(lines("heat flux (kW per m²)", "(kW per m²)"), (Lines{"heat flux", "(kW per m²)"}));
}

TEST(TitleLines, AUnitStaysWhereTheNameIsTooLong)
{
    const Lines found = lines("a very long name that nobody would read to its end [m²/s²]", "a very long na");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_TRUE(found[0].starts_with("a very") && found[0].ends_with("…")) << found[0];
    EXPECT_EQ(found[1], "[m²/s²]");
}

TEST(TitleLines, WithoutAUnitTheEndIsLeftOut)
{
    const Lines found = lines("a very long name that nobody would read", "a very long na");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], "a very long");
    EXPECT_TRUE(found[1].starts_with("name") && found[1].ends_with("…")) << found[1];
}

TEST(TitleLines, OneWordIsShortened)
{
    const Lines found = lines("wallShearStressMagnitude", "wallShearStress");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].ends_with("…"));
}

TEST(TitleLines, OddBracketsAndBytesAreSafe)
{
    for (const char* title : {"a] b[ c", "[[[ [ [ a b c d", ") ) ) ) (", "    ", " a", "\xff\xfe \x01 \xff", "[] []"})
        for (const char* widest : {"", "i", "iii", "WWWW", "WWWWWWWWWWWW"}) EXPECT_LE(lines(title, widest).size(), 2u);
}

}  // namespace
}  // namespace aeolic
