#include "render/overlay/figure.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "render/overlay/text_size.h"

/// What stands around the surface: nothing overlaps, nothing is cut off, whatever the picture and the texts are.
namespace aeolic {
namespace {

Picture filled(int width, int height, int channels, std::uint8_t value)
{
    return {width, height, channels,
            std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * std::size_t(channels), value)};
}

Figure fullFigure()
{
    Figure figure;
    const ColorTable& map = colorMap("viridis");
    figure.bars = {
        ScalarBar{{map.begin(), map.end()}, -1.5e-7, 3e-7, {}, "|v| [m s⁻¹]", Color{0, 0, 255}, Color{255, 0, 0}}};
    figure.title = "Wake <b>behind</b> a Größe $x^2$ & 渦";
    figure.stamp = "t = 0.350";
    figure.axes = Orientation{};
    return figure;
}

bool overlap(const Box& a, const Box& b)
{
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// The boxes of all parts, with the bar at one of its places, or without it.
std::vector<Box> boxesOf(const FigureLayout& layout, std::size_t place)
{
    std::vector<Box> boxes;
    for (const auto& box : {layout.title, layout.axes, layout.stamp})
        if (box) boxes.push_back(*box);
    if (place < layout.barPlaces.size()) boxes.push_back(layout.barPlaces[place]);
    return boxes;
}

TEST(Figure, TextInASmallerPictureThatIsStretchedIsAsLarge)
{
    const auto em = [](double textScale, int side) { return textScale * textSize(side, side); };
    for (const double textScale : {0.5, 1.0, 4.0})
        for (const int full : {200, 900, 2000, 4000})
            for (const int part : {1, 2, 4}) {
                const int small = full / part;
                const double scale = textScaleOfSmaller(textScale, small, small, full, full);
                EXPECT_LE(scale, textScale);
                EXPECT_GE(scale, 0.5) << "the least that the option takes";
                if (em(textScale, full) / part >= 7 && scale > 0.5) {
                    EXPECT_NEAR(em(scale, small) * part, em(textScale, full), 1e-9)
                        << textScale << " " << full << " " << part;
                }
            }
    EXPECT_NEAR(em(textScaleOfSmaller(1, 225, 225, 900, 900), 225), 7, 1e-9) << "a quarter could not be read";
    EXPECT_EQ(textScaleOfSmaller(1, 1, 1, 1, 1), 1);
    for (double textScale = 0.5; textScale < 4; textScale += 0.0371)
        EXPECT_EQ(textScaleOfSmaller(textScale, 1234, 987, 1234, 987), textScale) << "the full picture";
}

TEST(Figure, PartsNeitherOverlapNorLeaveThePicture)
{
    Figure figure = fullFigure();
    for (const double textScale : {0.5, 1.0, 1.7, 4.0})
        for (const int width : {16, 60, 100, 187, 200, 300, 640, 800, 1600, 4000})
            for (const int height : {16, 64, 100, 160, 200, 300, 480, 800, 1000, 2250, 4000}) {
                figure.textScale = textScale;
                const FigureLayout layout(figure, width, height);
                const std::string what = fmt::format("{}x{} with text {}", width, height, textScale);
                for (std::size_t place = 0; place <= layout.barPlaces.size(); ++place) {
                    const std::vector<Box> boxes = boxesOf(layout, place);
                    for (std::size_t a = 0; a < boxes.size(); ++a) {
                        EXPECT_TRUE(boxes[a].x >= 0 && boxes[a].y >= 0 && boxes[a].right() <= width &&
                                    boxes[a].bottom() <= height)
                            << what << " box " << a;
                        for (std::size_t b = 0; b < a; ++b)
                            EXPECT_FALSE(overlap(boxes[a], boxes[b])) << what << " " << a << " " << b;
                    }
                }
                if (height >= 200 && width >= 300 && textScale <= 1) {
                    EXPECT_EQ(boxesOf(layout, layout.barPlaces.size()).size(), 3u) << what;
                    EXPECT_GE(layout.barPlaces.size(), 2u) << what;
                    EXPECT_EQ(layout.leftOut(figure), "") << what;
                }
            }
}

TEST(Figure, SaysWhatIsLeftOut)
{
    Figure figure = fullFigure();
    EXPECT_EQ(FigureLayout(figure, 30, 30).leftOut(figure), "the title, the axes, the time and the legend");
    figure.bars.push_back(figure.bars.front());
    figure.bars.push_back(figure.bars.front());
    EXPECT_EQ(FigureLayout(figure, 300, 300).leftOut(figure), "1 of 3 legends");
    EXPECT_EQ(FigureLayout(Figure(), 30, 30).leftOut(Figure()), "");
}

/// Twice the text in a picture of twice the size is everything twice as large, but for rounding.
TEST(Figure, GrowsWithTheSizeOfItsText)
{
    Figure figure = fullFigure();
    const FigureLayout usual(figure, 400, 400);
    figure.textScale = 2;
    const FigureLayout larger(figure, 800, 800);
    EXPECT_EQ(usual.em, 10);
    EXPECT_EQ(larger.em, 30) << "the usual 15 in such a picture, twice";
    figure.textScale = 4.0 / 3;
    const FigureLayout twice(figure, 800, 800);
    EXPECT_NEAR(twice.title->width, 2 * usual.title->width, 3);
    EXPECT_NEAR(twice.axes->width, 2 * usual.axes->width, 1);
    EXPECT_NEAR(twice.barPlaces[0].height, 2 * usual.barPlaces[0].height, 8);
}

TEST(Figure, DrawsWithinItsBoxesAlone)
{
    const Figure figure = fullFigure();
    for (const auto& [width, height] : {std::pair{300, 200}, {801, 603}, {1600, 900}}) {
        const FigureLayout layout(figure, width, height);
        for (std::size_t place = 0; place < layout.barPlaces.size(); ++place) {
            Picture picture = filled(width, height, 3, 77);
            drawFigure(picture, figure, layout, place);
            std::vector<Box> boxes{*layout.title, *layout.axes, *layout.stamp, layout.barPlaces[place]};
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const Box pixel{x, y, 1, 1};
                    if (std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return overlap(pixel, box); }))
                        continue;
                    ASSERT_EQ(picture.pixels[std::size_t(3 * (width * y + x))], 77) << x << " " << y;
                }
        }
    }
}

TEST(Figure, ItsRowsAreThoseOfTheWhole)
{
    const Figure figure = fullFigure();
    const FigureLayout layout(figure, 400, 300);
    Picture whole = filled(400, 300, 4, 0);
    drawFigure(whole, figure, layout, 0);
    for (const int first : {0, 17, 150, 299}) {
        Picture part = filled(400, 1, 4, 0);
        drawFigure(PictureRows(part, 300, first), figure, layout, 0);
        EXPECT_TRUE(std::equal(part.pixels.begin(), part.pixels.end(), whole.pixels.begin() + 4 * 400 * first))
            << first;
    }
}

TEST(Figure, TheBarGoesWhereTheSurfaceIsNot)
{
    Figure figure;
    figure.bars = fullFigure().bars;
    const FigureLayout layout(figure, 800, 600);
    ASSERT_EQ(layout.barPlaces.size(), 4u);
    const std::array<std::uint8_t, 4> white{255, 255, 255, 255};
    const auto placeBeside = [&](std::vector<std::size_t> taken) {
        Picture picture = filled(800, 600, 3, 255);
        for (const std::size_t place : taken) {
            const Box& box = layout.barPlaces[place];
            picture.pixels[std::size_t(3 * (800 * (box.y + box.height / 2) + box.x + box.width / 2))] = 254;
        }
        return freestPlace(coveredPixels(picture, layout.barPlaces, white));
    };
    EXPECT_EQ(placeBeside({}), 0u) << "upper right where all are free";
    EXPECT_EQ(placeBeside({0}), 1u);
    EXPECT_EQ(placeBeside({0, 1}), 2u);
    EXPECT_EQ(placeBeside({0, 1, 2}), 3u);
    EXPECT_EQ(placeBeside({0, 1, 2, 3}), 0u) << "where a surface fills all of them alike";
    EXPECT_EQ(placeBeside({1, 2, 3}), 0u);
}

TEST(Figure, CoverageIsTheSumOfTheRows)
{
    Figure figure = fullFigure();
    const FigureLayout layout(figure, 300, 200);
    Picture whole = filled(300, 200, 4, 255);
    for (std::size_t i = 0; i < whole.pixels.size(); i += 7 * 4) whole.pixels[i + 3] = 0;
    const std::array<std::uint8_t, 4> background{255, 255, 255, 0};
    std::vector<std::int64_t> sum(layout.barPlaces.size(), 0);
    for (int first = 0; first < 200; first += 50) {
        Picture part{300, 50, 4, {}};
        part.pixels.assign(whole.pixels.begin() + 4 * 300 * first, whole.pixels.begin() + 4 * 300 * (first + 50));
        const auto some = coveredPixels(PictureRows(part, 200, first), layout.barPlaces, background);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += some[i];
    }
    EXPECT_EQ(coveredPixels(whole, layout.barPlaces, background), sum);
}

/// A long stamp that gets a digit more reaches below the left corner: the bars have the same places before and after.
TEST(Figure, TheBarsPlacesAreThoseOfAllStampsOfAnAnimation)
{
    Figure early = fullFigure();
    early.axes.reset();
    early.bars.push_back(early.bars.front());
    early.stamp = "t = 999999.500";
    Figure late = early;
    late.stamp = "t = 1000000.500";
    int different = 0;
    for (int width = 180; width <= 320; width += 2) {
        different += FigureLayout(early, width, 200).barPlaces != FigureLayout(late, width, 200).barPlaces;
        different += FigureLayout(early, width, 200).barPlaces != FigureLayout(late, width, 200).barPlaces;
        Figure first = early, last = late;
        first.otherStamps = last.otherStamps = {early.stamp, late.stamp};
        const FigureLayout one(first, width, 200), other(last, width, 200);
        EXPECT_EQ(one.barPlaces, other.barPlaces) << width;
        EXPECT_EQ(one.barCorners, other.barCorners) << width;
    }
    EXPECT_GT(different, 0) << "alone they have others";
}

/// A corner that has no room gives way to the one above or below, and to the other side only after that.
TEST(Figure, ACornerWithoutRoomGivesWayToTheNearest)
{
    using enum Corner;
    FigureLayout layout(Figure(), 400, 300);
    EXPECT_EQ(layout.placeIn(lowerLeft), 0u) << "where there is none";
    layout.barCorners = {upperRight, lowerRight, upperLeft, lowerLeft};
    for (const Corner corner : layout.barCorners) EXPECT_EQ(layout.barCorners[layout.placeIn(corner)], corner);
    layout.barCorners = {upperRight, lowerRight, upperLeft};
    EXPECT_EQ(layout.placeIn(lowerLeft), 2u);
    layout.barCorners = {upperRight, lowerRight};
    EXPECT_EQ(layout.placeIn(lowerLeft), 1u);
    EXPECT_EQ(layout.placeIn(upperLeft), 0u);
    layout.barCorners = {upperRight, upperLeft};
    EXPECT_EQ(layout.placeIn(lowerRight), 0u);
    layout.barCorners = {lowerLeft};
    EXPECT_EQ(layout.placeIn(upperRight), 0u);
}

TEST(Figure, OddTextsAreSafe)
{
    for (const std::string& text : {std::string(), std::string("\xff\xfe"), std::string(100000, 'W'),
                                    std::string("line\nline"), std::string("%s%n"), std::string("\xe2\x80\xae rtl")}) {
        Figure figure = fullFigure();
        figure.title = figure.stamp = figure.bars.front().title = text;
        Picture picture = filled(300, 200, 3, 128);
        const FigureLayout layout(figure, 300, 200);
        drawFigure(picture, figure, layout, 0);
        EXPECT_EQ(layout.title.has_value(), !text.empty());
        if (layout.title) {
            EXPECT_LE(layout.title->right(), 300);
        }
    }
}

TEST(Figure, AxesPointWhereTheViewShowsThem)
{
    Figure figure;
    figure.axes = Orientation{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};  // x to the right, z up, y away.
    Picture picture = filled(800, 800, 3, 255);
    const FigureLayout layout(figure, 800, 800);
    drawFigure(picture, figure, layout, 0);
    const Box box = *layout.axes;
    const auto at = [&](double x, double y) {
        const auto* pixel =
            &picture.pixels[std::size_t(3 * (800 * (box.y + int(y * box.height)) + box.x + int(x * box.width)))];
        return Color{pixel[0], pixel[1], pixel[2]};
    };
    EXPECT_EQ(at(0.65, 0.5), (Color{200, 30, 45})) << "x to the right";
    EXPECT_EQ(at(0.5, 0.35), (Color{30, 80, 200})) << "z upwards";
    EXPECT_EQ(at(0.35, 0.5), (Color{255, 255, 255})) << "nothing to the left";
}

}  // namespace
}  // namespace aeolic
