#include "render/overlay/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/overlay/text_size.h"

namespace aeolic {
namespace {

constexpr double lowestPicture = 6.4;  // In ems: 64 rows. Below, the surface needs all of them.
constexpr double titleSize = 1.25;     // In ems.
constexpr double axesSize = 5.6;       // In ems, for letters beside arms that one can tell apart.
constexpr double axesShare = 0.3;      // The axes never take more of the picture's sides than this.

constexpr double widestBars = 0.6;  // Several bars take no more of the picture's width than this.

int barGap(double em)
{
    return wholePx(0.5 * em);
}

/// What a line of text takes on its panel.
struct Line {
    double em;
    int padding, height;

    explicit Line(double size) : em(size), padding(wholePx(0.6 * size)), height(wholePx(1.9 * size)) {}

    int baseline(const Box& box) const { return box.y + wholePx(0.5 * height + 0.36 * em); }
    /// The box of the text, or nothing if not even its first letter fits.
    std::optional<Box> box(const std::string& text, int widest) const
    {
        const TextPainter painter(em);
        const std::string fitted = painter.fitted(text, widest - 2 * padding);
        if (fitted.empty()) return std::nullopt;
        return Box{0, 0, int(std::ceil(painter.widthPx(fitted))) + 2 * padding, height};
    }
    void draw(const PictureRows& picture, const Box& box, const std::string& text, const InkColors& colors) const
    {
        const TextPainter painter(em);
        drawPanel(picture, box, 0.4 * em, colors.paper);
        painter.draw(picture, box.x + padding, baseline(box), painter.fitted(text, box.width - 2 * padding + 0.5),
                     colors.ink);
    }
};

}  // namespace

FigureLayout::FigureLayout(const Figure& figure, int width, int height) : em(figure.textScale * textSize(width, height))
{
    if (height < lowestPicture * em) return;
    const int margin = wholePx(0.9 * em), gap = barGap(em);
    int top = margin, bottomLeft = height - margin, bottomRight = height - margin;

    title = Line(titleSize * em).box(figure.title, width - 2 * margin);
    if (title) {
        title->x = (width - title->width) / 2;
        title->y = margin;
        top = title->bottom() + gap;
    }
    const int side = wholePx(axesSize * em);
    if (figure.axes && side <= axesShare * width && side <= axesShare * height) {
        axes = Box{margin, height - margin - side, side, side};
        bottomLeft = axes->y - gap;
    }
    const int left = axes ? axes->right() + gap : margin;
    stamp = Line(em).box(figure.stamp, width - margin - left);
    if (stamp && top + stamp->height <= height - margin) {
        stamp->x = width - margin - stamp->width;
        stamp->y = height - margin - stamp->height;
        bottomRight = stamp->y - gap;
    } else {
        stamp.reset();
    }
    // A bar alone may reach into the margin, which in small pictures would leave it no room.
    const int lowestRight = stamp ? bottomRight : height, lowestLeft = axes ? bottomLeft : height;
    int barsWidth = 0, barsHeight = 0;
    for (const ScalarBar& bar : figure.bars) {
        const ScalarBarLayout layout(bar, em, width, height, std::max(lowestLeft, lowestRight) - top);
        const int wider = barsWidth + (bars.empty() ? 0 : gap) + layout.width;
        if (layout.width == 0 || (!bars.empty() && wider > widestBars * width)) break;
        barsWidth = wider;
        barsHeight = std::max(barsHeight, layout.height);
        bars.push_back(layout);
    }
    if (bars.empty()) return;
    const int right = width - margin - barsWidth;
    const auto add = [&](Corner corner, int x, int y, int lowest) {
        if (y < top || y + barsHeight > lowest) return;
        barPlaces.push_back({x, y, barsWidth, barsHeight});
        barCorners.push_back(corner);
    };
    // A wide stamp reaches below the left corner, too.
    int widestStamp = stamp ? stamp->width : 0;
    if (stamp)
        for (const std::string& other : figure.otherStamps)
            if (const auto box = Line(em).box(other, width - margin - left))
                widestStamp = std::max(widestStamp, box->width);
    const bool isBelowLeft = stamp && width - margin - widestStamp < margin + barsWidth;
    const int lowestFarLeft = isBelowLeft ? std::min(lowestLeft, bottomRight) : lowestLeft;
    add(Corner::upperRight, right, top, lowestRight);
    add(Corner::lowerRight, right, bottomRight - barsHeight, lowestRight);
    add(Corner::upperLeft, margin, top, lowestFarLeft);
    if (!axes) add(Corner::lowerLeft, margin, std::min(bottomLeft, lowestFarLeft) - barsHeight, lowestFarLeft);
}

std::size_t FigureLayout::placeIn(Corner corner) const
{
    const auto distance = [&](Corner other) { return unsigned(other) ^ unsigned(corner); };
    const auto isNearer = [&](Corner a, Corner b) { return distance(a) < distance(b); };
    return std::size_t(std::min_element(barCorners.begin(), barCorners.end(), isNearer) - barCorners.begin());
}

std::string FigureLayout::leftOut(const Figure& figure) const
{
    std::vector<std::string> parts;
    if (!figure.title.empty() && !title) parts.emplace_back("the title");
    if (figure.axes && !axes) parts.emplace_back("the axes");
    if (!figure.stamp.empty() && !stamp) parts.emplace_back("the time");
    const std::size_t drawn = barPlaces.empty() ? 0 : bars.size();
    if (drawn < figure.bars.size())
        parts.push_back(figure.bars.size() == 1
                            ? "the legend"
                            : fmt::format("{} of {} legends", figure.bars.size() - drawn, figure.bars.size()));
    if (parts.size() < 2) return parts.empty() ? "" : parts.front();
    const std::string last = parts.back();
    parts.pop_back();
    return fmt::format("{} and {}", fmt::join(parts, ", "), last);
}

std::vector<std::int64_t> coveredPixels(const PictureRows& picture, const std::vector<Box>& boxes,
                                        const std::array<std::uint8_t, 4>& background)
{
    std::vector<std::int64_t> covered;
    for (const Box& box : boxes) {
        std::int64_t count = 0;
        const int y1 = std::min(box.bottom(), picture.firstRow + picture.rows);
        for (int y = std::max(box.y, picture.firstRow); y < y1; ++y) {
            const std::uint8_t* pixel =
                picture.pixels + (std::size_t(y - picture.firstRow) * std::size_t(picture.width) + std::size_t(box.x)) *
                                     std::size_t(picture.channels);
            for (int x = 0; x < box.width; ++x, pixel += picture.channels)
                count += !std::equal(pixel, pixel + picture.channels, background.begin());
        }
        covered.push_back(count);
    }
    return covered;
}

std::size_t freestPlace(const std::vector<std::int64_t>& covered)
{
    return std::size_t(std::min_element(covered.begin(), covered.end()) - covered.begin());
}

void drawFigure(const PictureRows& picture, const Figure& figure, const FigureLayout& layout, std::size_t barPlace)
{
    const InkColors colors = colorsOf(figure.inks);
    if (barPlace < layout.barPlaces.size()) {
        const Box& place = layout.barPlaces[barPlace];
        int x = place.x;
        for (const ScalarBarLayout& bar : layout.bars) {
            bar.draw(picture, x, place.y, figure.inks);
            x += bar.width + barGap(layout.em);
        }
    }
    if (layout.title) Line(titleSize * layout.em).draw(picture, *layout.title, figure.title, colors);
    if (layout.stamp) Line(layout.em).draw(picture, *layout.stamp, figure.stamp, colors);
    if (layout.axes) drawOrientationAxes(picture, *layout.axes, *figure.axes, layout.em, figure.inks);
}

}  // namespace aeolic
