#include "render/overlay/figure.h"

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

/// Draws a bar alone, in the upper right corner, where it fits.
void drawScalarBar(Picture& picture, const ColorTable& colors, double lo, double hi, const std::string& title,
                   Inks inks = Inks::dark, const ScalarBar& like = {})
{
    Figure figure;
    figure.bars = {like};
    figure.bars.front().colors.assign(colors.begin(), colors.end());
    figure.bars.front().lo = lo;
    figure.bars.front().hi = hi;
    figure.bars.front().title = title;
    figure.inks = inks;
    drawFigure(picture, figure, FigureLayout(figure, picture.width, picture.height), 0);
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

TEST(ScalarBar, StreaksFadeOrGetShorterTowardsTheLowEnd)
{
    for (const BarFill fill : {BarFill::fadingStreaks, BarFill::shorterStreaks}) {
        Picture picture = filled(800, 800, 3, 255);
        ScalarBar bar;
        bar.fill = fill;
        Figure figure;
        figure.bars = {bar};
        figure.bars.front().colors = {Color{170, 170, 170}};
        drawFigure(picture, figure, FigureLayout(figure, 800, 800), 0);
        const auto differs = [&](int from, int to) {  // From the mean tone, in rows of the bar.
            std::int64_t sum = 0;
            for (int y = from; y < to; ++y)
                for (int x = 720; x < 740; ++x)
                    sum += std::abs(int(picture.pixels[std::size_t(3 * (800 * y + x))]) - 170);
            return sum;
        };
        EXPECT_GT(differs(60, 120), differs(200, 260));
    }
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

/// Without labels it would say nothing, and hide the surface.
TEST(ScalarBar, IsLeftOutWhereItsLabelsHaveNoRoom)
{
    Figure figure;
    figure.bars = {{{{0, 0, 0}, {255, 255, 255}}, 100.5, 101.5, {}, "p", {}, {}}};
    const auto leftOut = [&](int width, int height) {
        Picture picture = filled(width, height, 3, 50);
        const FigureLayout layout(figure, width, height);
        drawFigure(picture, figure, layout, 0);
        EXPECT_EQ(picture.pixels == filled(width, height, 3, 50).pixels, layout.bars.empty());
        EXPECT_EQ(layout.leftOut(figure), layout.bars.empty() ? "the legend" : "");
        return layout.bars.empty();
    };
    EXPECT_TRUE(leftOut(160, 160));
    EXPECT_TRUE(leftOut(120, 400)) << "a narrow one";
    EXPECT_TRUE(leftOut(400, 90)) << "a low one";
    EXPECT_FALSE(leftOut(240, 240));
    figure.textScale = 4;
    EXPECT_TRUE(leftOut(240, 240));
    EXPECT_FALSE(leftOut(2400, 2400));
}

/// A second line of the title is taken from the bar, but never from the legend itself.
TEST(ScalarBar, AWideTitleTakesALineMoreWhereThereIsRoom)
{
    Figure narrow, wide;
    narrow.bars = {{{{0, 0, 0}, {255, 255, 255}}, 0, 1, {}, "p", {}, {}}};
    wide.bars = narrow.bars;
    wide.bars.front().title = "wall shear stress magnitude [Pa]";
    wide.stamp = narrow.stamp = "t = 0.5";
    const FigureLayout usual(narrow, 800, 800), higher(wide, 800, 800);
    ASSERT_EQ(usual.bars.size() + higher.bars.size(), 2u);
    EXPECT_GT(higher.bars.front().height, usual.bars.front().height);
    EXPECT_GT(higher.bars.front().width, usual.bars.front().width);
    for (int height = 60; height < 400; ++height) {
        const FigureLayout small(narrow, 300, height), smallToo(wide, 300, height);
        EXPECT_EQ(small.barPlaces.empty(), smallToo.barPlaces.empty()) << height;
    }
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

/// The colours of the bar, from the bottom to the top, in a column through its middle.
std::vector<Color> columnOf(const Picture& picture, const Color& lowest, const Color& ink)
{
    const auto at = [&](int x, int y) {
        const std::uint8_t* pixel = &picture.pixels[std::size_t(picture.channels * (picture.width * y + x))];
        return Color{pixel[0], pixel[1], pixel[2]};
    };
    int x = picture.width - 1, y = rowsWith(picture, lowest).second;
    while (x > 0 && at(x, y) != lowest) --x;
    std::vector<Color> column;
    for (; y >= 0 && at(x, y) != ink; --y) column.push_back(at(x, y));
    return column;
}

TEST(ScalarBar, HasTheColourMapsOwnColoursInTheirOrder)
{
    for (const std::string_view name : colorMapNames()) {
        if (name == "twilight") continue;  // Its ends are alike: the lowest colour is found at the top.
        Picture picture = filled(900, 900, 3, 128);
        drawScalarBar(picture, colorMap(name), 0, 1, "p", Inks::light);  // Of an ink that no map has.
        const std::vector<Color> column = columnOf(picture, colorMap(name).front(), {232, 234, 236});
        ASSERT_GT(column.size(), 300u) << name;
        std::size_t entry = 0;
        for (const Color& color : column) {  // Ascending, and no colour between them.
            while (entry < 256 && colorMap(name)[entry] != color) ++entry;
            ASSERT_LT(entry, 256u) << name;
        }
        EXPECT_EQ(column.back(), colorMap(name).back());
    }
}

TEST(ScalarBar, BandsHaveOneColourEach)
{
    Figure figure;
    figure.bars = {ScalarBar{{{10, 0, 0}, {0, 20, 0}, {0, 0, 30}}, 0, 3, {ColorScale::Kind::bands, 3}, "", {}, {}}};
    Picture picture = filled(800, 800, 3, 128);
    drawFigure(picture, figure, FigureLayout(figure, 800, 800), 0);
    const std::vector<Color> column = columnOf(picture, {10, 0, 0}, {26, 26, 26});
    ASSERT_EQ(column.size(), 288u);
    for (std::size_t i = 0; i < column.size(); ++i) EXPECT_EQ(column[i], figure.bars.front().colors[i / 96]) << i;
}

TEST(ScalarBar, ColoursBeyondTheRangeStandBeyondItsEnds)
{
    Picture picture = filled(800, 800, 3, 128);
    ScalarBar bar;
    bar.below = Color{1, 2, 3};
    bar.above = Color{201, 202, 3};
    drawScalarBar(picture, colorMap("viridis"), 0, 1, "p", Inks::dark, bar);
    const auto above = rowsWith(picture, {201, 202, 3}), high = rowsWith(picture, colorMap("viridis").back()),
               low = rowsWith(picture, colorMap("viridis").front()), below = rowsWith(picture, {1, 2, 3});
    ASSERT_GE(above.first, 0);
    EXPECT_LT(above.second, high.first);
    EXPECT_LT(high.second, low.first);
    EXPECT_LT(low.second, below.first);
}

TEST(ScalarBar, StandsLightOnDarkBackgrounds)
{
    EXPECT_EQ(inksFor("ffffff"), Inks::dark);
    EXPECT_EQ(inksFor("transparent"), Inks::dark);
    EXPECT_EQ(inksFor("11161a"), Inks::light);
    EXPECT_EQ(inksFor("0000ff"), Inks::light) << "blue is dark";
    EXPECT_EQ(inksFor("00ff00"), Inks::dark) << "green is light";
    Picture picture{400, 400, 3, std::vector<std::uint8_t>(400 * 400 * 3, 20)};
    drawScalarBar(picture, colorMap("viridis"), 0, 1, "p", Inks::light);
    const int corner = (20 * 400 + 380) * 3;  // In the panel, whose paper is darker than the picture.
    EXPECT_LT(picture.pixels[std::size_t(corner)], 20);
    EXPECT_GT(*std::max_element(picture.pixels.begin(), picture.pixels.end()), 220) << "the ink";
}

}  // namespace
}  // namespace aeolic
