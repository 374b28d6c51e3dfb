#include "render/overlay/scalar_bar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace aeolic {
namespace {

Picture filled(int width, int height, int channels, std::uint8_t value)
{
    return {width, height, channels,
            std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * std::size_t(channels), value)};
}

/// Rows of the picture that hold this colour, first and last; {-1, -1} if none does.
std::pair<int, int> rowsWith(const Picture& picture, const std::array<std::uint8_t, 3>& color)
{
    std::pair<int, int> rows{-1, -1};
    for (std::size_t i = 0; i + 2 < picture.pixels.size(); i += std::size_t(picture.channels))
        if (std::equal(color.begin(), color.end(), &picture.pixels[i])) {
            const int row = int(i / std::size_t(picture.channels) / std::size_t(picture.width));
            if (rows.first < 0) rows.first = row;
            rows.second = row;
        }
    return rows;
}

TEST(ScalarBar, RunsFromTheLowColourBelowToTheHighOneAbove)
{
    Picture picture = filled(800, 800, 3, 128);
    drawScalarBar(picture, colorMap("viridis"), 0, 1, "p");
    const auto high = rowsWith(picture, colorMap("viridis").back()),
               low = rowsWith(picture, colorMap("viridis").front());
    ASSERT_GE(high.first, 0);
    ASSERT_GE(low.first, 0);
    EXPECT_LT(high.second, low.first);
    EXPECT_NEAR(low.second - high.first + 1, 0.36 * 800, 1);
}

TEST(ScalarBar, SamePixelsEveryTime)
{
    Picture first = filled(640, 480, 4, 30), second = first;
    drawScalarBar(first, colorMap("turbo"), -1400, 800, "wall shear stress / Pa");
    drawScalarBar(second, colorMap("turbo"), -1400, 800, "wall shear stress / Pa");
    EXPECT_EQ(first.pixels, second.pixels);
    EXPECT_NE(first.pixels, filled(640, 480, 4, 30).pixels);
}

TEST(ScalarBar, StaysOnTheRight)
{
    Picture picture = filled(800, 600, 3, 7);
    drawScalarBar(picture, colorMap("gray"), 1e-7, 3e-7, std::string(500, 'W'));
    for (int y = 0; y < 600; ++y)
        for (int x = 0; x < 480; ++x) ASSERT_EQ(picture.pixels[std::size_t(3 * (800 * y + x))], 7) << x << " " << y;
}

TEST(ScalarBar, TextIsDarkOnLightOverAnyBackground)
{
    for (const std::uint8_t background : {0, 128, 255}) {
        Picture picture = filled(400, 400, 3, background);
        drawScalarBar(picture, colorMap("viridis"), 0, 1, "pressure");
        const auto ink = rowsWith(picture, {26, 26, 26});
        ASSERT_GE(ink.first, 0);
        std::uint8_t paper = std::uint8_t((204 * 255 + 51 * background) / 255);
        const auto panel = rowsWith(picture, {paper, paper, paper});
        EXPECT_LE(panel.first, ink.first);
        EXPECT_GE(panel.second, ink.second);
        EXPECT_GE(paper, 200);
    }
}

TEST(ScalarBar, OverATransparentBackgroundItCarriesItsOwnOpacity)
{
    Picture picture = filled(400, 400, 4, 0);
    drawScalarBar(picture, colorMap("viridis"), 0, 1, "p");
    std::uint8_t most = 0;
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4) most = std::max(most, picture.pixels[i]);
    EXPECT_EQ(most, 255);
    EXPECT_EQ(picture.pixels[3], 0);
}

/// A picture of one value is drawn in the table's first colour: the tick must stand there.
TEST(ScalarBar, SingleValueIsLabelledAtTheLowEnd)
{
    Picture picture = filled(800, 800, 3, 255);
    drawScalarBar(picture, colorMap("viridis"), 5, 5, "");
    const auto pixel = [&](int x, int y) { return &picture.pixels[std::size_t(3 * (800 * y + x))]; };
    const int lowEnd = rowsWith(picture, colorMap("viridis").front()).second;
    int barEnd = 799;
    while (!std::equal(pixel(barEnd, lowEnd), pixel(barEnd, lowEnd) + 3, colorMap("viridis").front().begin())) --barEnd;
    for (int y = 0; y < 800; ++y)  // Three pixels beside the bar only a tick is black.
        EXPECT_EQ(*pixel(barEnd + 3, y) < 128, y == lowEnd + 1) << y;
}

TEST(ScalarBar, TinyAndOddPicturesAreSafe)
{
    for (int width : {1, 2, 17, 63, 64, 100, 161, 3000})
        for (int height : {1, 2, 63, 64, 65, 120, 160, 2000}) {
            Picture picture = filled(width, height, 3, 50);
            drawScalarBar(picture, colorMap("plasma"), -1, 1, "a rather long title");
            EXPECT_EQ(picture.pixels.size(), std::size_t(3 * width * height));
        }
    Picture tiny = filled(60, 60, 3, 50);
    drawScalarBar(tiny, colorMap("plasma"), -1, 1, "p");
    EXPECT_EQ(tiny.pixels, filled(60, 60, 3, 50).pixels);
}

TEST(ScalarBar, OddRangesAndTitlesAreSafe)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const Picture blank = filled(300, 300, 3, 255);
    for (const auto& [lo, hi] : {std::pair{5.0, 5.0}, {0.0, 0.0}, {-1.7e308, 1.7e308}, {0.0, 5e-324}, {1.0, 1 + 1e-15}})
        for (const char* title : {"", "p", "\xff\xfe\x01", "Größe θ [m²/s²]"}) {
            Picture picture = blank;
            drawScalarBar(picture, colorMap("viridis"), lo, hi, title);
            EXPECT_NE(picture.pixels, blank.pixels);
        }
    Picture picture = blank;
    drawScalarBar(picture, colorMap("viridis"), 0, infinity, "p");
    EXPECT_EQ(picture.pixels, blank.pixels);
}

TEST(ScalarBar, StandsLightOnDarkBackgrounds)
{
    EXPECT_EQ(barInksFor("ffffff"), BarInks::dark);
    EXPECT_EQ(barInksFor("transparent"), BarInks::dark);
    EXPECT_EQ(barInksFor("11161a"), BarInks::light);
    EXPECT_EQ(barInksFor("0000ff"), BarInks::light) << "blue is dark";
    EXPECT_EQ(barInksFor("00ff00"), BarInks::dark) << "green is light";
    Picture picture{400, 400, 3, std::vector<std::uint8_t>(400 * 400 * 3, 20)};
    drawScalarBar(picture, colorMap("viridis"), 0, 1, "p", BarInks::light);
    const int corner = (20 * 400 + 380) * 3;  // In the panel, whose paper is darker than the picture.
    EXPECT_LT(picture.pixels[std::size_t(corner)], 20);
    EXPECT_GT(*std::max_element(picture.pixels.begin(), picture.pixels.end()), 220) << "the ink";
}

}  // namespace
}  // namespace aeolic
