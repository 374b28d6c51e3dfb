#include "render/overlay/scalar_bar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/overlay/title_lines.h"

namespace aeolic {
namespace {

constexpr double widestShare = 0.4;  // The bar never takes more of the picture's width than this.
// The bar takes this share of the picture's height. A fitted view mostly leaves so much free in its corner.
constexpr double barShare = 0.36;
constexpr double lowestBar = 3.6;  // In ems: three labels have room beside it.

Ticks ticksOf(const ScalarBar& bar, int most)
{
    if (!(bar.hi > bar.lo)) return niceTicks(bar.lo, bar.hi, most);
    switch (bar.scale.kind) {
        case ColorScale::Kind::linear:
            break;
        case ColorScale::Kind::log:
            return logTicks(bar.lo, bar.hi, most);
        case ColorScale::Kind::bands:
            return bandTicks(bar.lo, bar.hi, bar.scale.bands, most);
    }
    return niceTicks(bar.lo, bar.hi, most);
}

/// How far up the bar a value stands, 0 to 1.
double partOf(const ScalarBar& bar, double value)
{
    if (!(bar.hi > bar.lo)) return 0;
    const double part = bar.scale.kind == ColorScale::Kind::log ? std::log(value / bar.lo) / std::log(bar.hi / bar.lo)
                                                                // Halves, so that the widest ranges do not overflow.
                                                                : (value / 2 - bar.lo / 2) / (bar.hi / 2 - bar.lo / 2);
    return std::clamp(part, 0.0, 1.0);
}

}  // namespace

ScalarBarLayout::ScalarBarLayout(const ScalarBar& bar, double em, int pictureWidth, int pictureHeight, int highest)
    : bar_(bar), em_(em)
{
    if (!std::isfinite(bar.lo) || !std::isfinite(bar.hi) || bar.colors.empty()) return;
    if (!fit(pictureWidth, pictureHeight, highest, 2) && !fit(pictureWidth, pictureHeight, highest, 1))
        width = height = 0;
}

bool ScalarBarLayout::fit(int pictureWidth, int pictureHeight, int highest, int mostLines)
{
    const int least = wholePx(lowestBar * em_);
    box_.height = wholePx(barShare * pictureHeight);
    layOut(pictureWidth, mostLines);
    if (height > highest) {
        box_.height = std::max(least, box_.height - (height - highest));
        layOut(pictureWidth, mostLines);
    }
    return box_.height >= least && height <= highest && width <= widestShare * pictureWidth;
}

void ScalarBarLayout::layOut(int pictureWidth, int mostLines)
{
    const TextPainter text(em_);
    line_ = std::max(1, wholePx(em_ / 16));
    tickLength_ = wholePx(0.4 * em_);
    end_ = wholePx(0.9 * em_);
    box_.width = wholePx(1.2 * em_);
    ticks_ = ticksOf(bar_, std::clamp(int(box_.height / (2.75 * em_)), 3, 7));

    const int padding = wholePx(0.85 * em_), gap = wholePx(0.4 * em_);
    lineHeight_ = wholePx(1.45 * em_);
    double labelWidth = text.widthPx(ticks_.factor);
    for (const std::string& label : ticks_.labels) labelWidth = std::max(labelWidth, text.widthPx(label));
    double contentWidth = box_.width + tickLength_ + gap + labelWidth;
    const double widest = std::min(std::max(contentWidth, std::clamp(0.25 * pictureWidth, 10 * em_, 14 * em_)),
                                   widestShare * pictureWidth - 2 * padding);
    title_ = mostLines > 1 ? titleLines(bar_.title, widest, text) : std::vector{text.fitted(bar_.title, widest)};
    std::erase(title_, "");
    for (const std::string& line : title_) contentWidth = std::max(contentWidth, text.widthPx(line));
    const int lines = int(title_.size()) + (ticks_.factor.empty() ? 0 : 1);
    const int header = lines == 0 ? 0 : lines * lineHeight_ + wholePx(0.5 * em_);
    const int above = bar_.above ? end_ + line_ : 0, below = bar_.below ? end_ + line_ : 0;
    width = int(std::ceil(contentWidth)) + 2 * padding;
    height = above + box_.height + below + header + 2 * padding;
    box_.x = padding;
    box_.y = padding + header + above;
    labelX_ = box_.x + box_.width + tickLength_ + gap;
    titleBaseline_ = padding + wholePx(0.85 * em_);
}

void ScalarBarLayout::drawColors(const PictureRows& picture, const Box& box, const Rgb& ink) const
{
    // A field beyond each end whose colour is a colour of its own, and lines around all.
    const int above = bar_.above ? end_ + line_ : 0, below = bar_.below ? end_ + line_ : 0;
    fillBox(picture,
            {box.x - line_, box.y - line_ - above, box.width + 2 * line_, above + box.height + below + 2 * line_}, ink);
    if (bar_.above) fillBox(picture, {box.x, box.y - above, box.width, end_}, *bar_.above);
    if (bar_.below) fillBox(picture, {box.x, box.bottom() + line_, box.width, end_}, *bar_.below);
    if (bar_.fill != BarFill::colors) return drawStreaks(picture, box);
    const auto count = double(bar_.colors.size());
    for (int y = 0; y < box.height; ++y) {
        const double part = 1 - (y + 0.5) / box.height;
        fillBox(picture, {box.x, box.y + y, box.width, 1},
                bar_.colors[std::size_t(std::clamp(part * count, 0.0, count - 1))]);
    }
}

void ScalarBarLayout::drawStreaks(const PictureRows& picture, const Box& box) const
{
    // Light and dark streaks of uneven widths, along the bar where they fade, and across it where they get shorter.
    constexpr std::array<double, 12> tones{0.9, -0.5, 0.2, -1, 0.6, -0.2, 1, -0.8, 0.4, -0.6, 0.8, -0.3};
    const int thickness = std::max(1, wholePx(em_ / 9));
    const auto shade = [&](double tone) {
        const auto one = [&](int base) { return std::uint8_t(std::clamp(double(base) + 80 * tone, 0.0, 255.0)); };
        const Color& mean = bar_.colors.front();
        return Color{one(mean[0]), one(mean[1]), one(mean[2])};
    };
    for (int y = 0; y < box.height; ++y) {
        const double part = 1 - (y + 0.5) / box.height;
        if (bar_.fill == BarFill::fadingStreaks) {
            for (int x = 0; x < box.width; x += thickness) {
                const double tone = tones[std::size_t(x / thickness) % tones.size()] * std::sqrt(part);
                fillBox(picture, {box.x + x, box.y + y, std::min(thickness, box.width - x), 1}, shade(tone));
            }
        } else {
            const int length = wholePx(part * box.width);
            const double tone = tones[std::size_t(y / thickness) % tones.size()];
            fillBox(picture, {box.x, box.y + y, length, 1}, shade(tone));
            fillBox(picture, {box.x + length, box.y + y, box.width - length, 1}, bar_.colors.front());
        }
    }
}

void ScalarBarLayout::drawTicks(const PictureRows& picture, const Box& box, const TextPainter& text,
                                const Rgb& ink) const
{
    for (std::size_t i = 0; i < ticks_.values.size(); ++i) {
        const double y = box.y + (1 - partOf(bar_, ticks_.values[i])) * box.height;
        // At the ends the tick continues the outline.
        const int row = std::clamp(wholePx(y - 0.5 * line_), box.y - line_, box.bottom());
        fillBox(picture, {box.right(), row, tickLength_, line_}, ink);
        const int baseline = wholePx(row + 0.5 * line_ + 0.5 * text.digitHeightPx());
        text.draw(picture, box.right() + labelX_ - box_.right(), baseline, ticks_.labels[i], ink);
    }
}

void ScalarBarLayout::draw(const PictureRows& picture, int x, int y, Inks inks) const
{
    if (width == 0) return;
    const TextPainter text(em_);
    const auto [ink, paper] = colorsOf(inks);
    const Box box{x + box_.x, y + box_.y, box_.width, box_.height};
    drawPanel(picture, {x, y, width, height}, 0.5 * em_, paper);
    drawColors(picture, box, ink);
    drawTicks(picture, box, text, ink);
    int baseline = y + titleBaseline_;
    for (const std::string& line : title_) {
        text.draw(picture, box.x - line_, baseline, line, ink);
        baseline += lineHeight_;
    }
    text.draw(picture, x + labelX_, baseline, ticks_.factor, ink);
}

}  // namespace aeolic
