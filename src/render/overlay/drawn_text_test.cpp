#include "render/overlay/drawn_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace aeolic {
namespace {

Picture filled(int width, int height, int channels, std::uint8_t value)
{
    return {width, height, channels,
            std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * std::size_t(channels), value)};
}

TEST(Text, KnowsWhatTheFontHasNot)
{
    const TextPainter painter(10);
    EXPECT_EQ(painter.unknownIn("Größe |U| [m s⁻¹] ρ ∇·u Ж"), "");
    EXPECT_EQ(painter.unknownIn("渦度 of 渦 and 流"), "渦度流") << "each once";
    EXPECT_EQ(painter.unknownIn("\xff\n"), "") << "those have a sign of their own";
}

TEST(Blend, OpaqueReplacesAndHalfIsTheMean)
{
    Picture picture = filled(1, 1, 3, 100);
    blendPixel(picture, 0, 0, {200, 0, 100}, 128);
    EXPECT_NEAR(picture.pixels[0], 150, 1);
    EXPECT_NEAR(picture.pixels[1], 50, 1);
    EXPECT_EQ(picture.pixels[2], 100);
    blendPixel(picture, 0, 0, {1, 2, 3}, 255);
    EXPECT_EQ(picture.pixels, (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST(Blend, OverNothingKeepsTheColourAndItsOpacity)
{
    Picture picture = filled(1, 1, 4, 0);
    blendPixel(picture, 0, 0, {10, 20, 30}, 77);
    EXPECT_EQ(picture.pixels, (std::vector<std::uint8_t>{10, 20, 30, 77}));
}

TEST(Blend, OutsideThePictureNothingHappens)
{
    Picture picture = filled(2, 2, 3, 9);
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {2, 0}, {0, 2}}) blendPixel(picture, x, y, {0, 0, 0}, 255);
    EXPECT_EQ(picture.pixels, filled(2, 2, 3, 9).pixels);
}

TEST(Text, WidthGrowsWithTheTextAndInProportionToTheSize)
{
    const TextPainter small(10), large(40);
    EXPECT_EQ(small.widthPx(""), 0);
    EXPECT_GT(small.widthPx("mm"), small.widthPx("m"));
    EXPECT_NEAR(large.widthPx("pressure"), 4 * small.widthPx("pressure"), 1);
    EXPECT_NEAR(large.digitHeightPx(), 0.74 * 40, 1);  // DejaVu's digits.
}

TEST(Text, BrokenUtf8CountsAsReplacementCharacters)
{
    const TextPainter text(20);
    const double one = text.widthPx("\xef\xbf\xbd");
    for (const char* broken : {"\xff", "\xc0", "\xe2\x82", "\xed\xa0\x80", "\x01", "\xf4\x90\x80\x80"})
        EXPECT_NEAR(text.widthPx(broken), one, 0.1) << broken;
}

TEST(Text, LongTextIsCutWithAnEllipsisThatFits)
{
    const TextPainter text(12);
    EXPECT_EQ(text.fitted("p", 100), "p");
    const std::string cut = text.fitted("Überströmungsgeschwindigkeit", 80);
    EXPECT_TRUE(cut.ends_with("…")) << cut;
    EXPECT_TRUE(cut.starts_with("Übers")) << cut;
    EXPECT_LE(text.widthPx(cut), 80);
    EXPECT_EQ(text.fitted("pressure", 1), "");
    EXPECT_LE(text.widthPx(text.fitted(std::string(1000000, 'i'), 80)), 80);
}

TEST(Text, DrawsWhereItSays)
{
    Picture picture = filled(60, 30, 3, 255);
    const TextPainter text(20);
    text.draw(picture, 10, 20, "H", {0, 0, 0});
    int left = 60, right = -1, top = 30, bottom = -1;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 60; ++x)
            if (picture.pixels[std::size_t(3 * (60 * y + x))] < 128) {
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = std::max(bottom, y);
            }
    EXPECT_EQ(bottom, 19);  // The row above the baseline's lower edge.
    EXPECT_NEAR(top, 20 - 0.729 * 20, 1);
    EXPECT_GE(left, 10);
    EXPECT_LE(right, 10 + text.widthPx("H"));
}

}  // namespace
}  // namespace aeolic
