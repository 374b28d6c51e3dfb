#include "render/overlay/scalar_bar.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/text.h"
#include "render/overlay/ticks.h"

namespace aeolic {

namespace {

/// The colours of text and lines, and of the panel behind them.
struct Colors {
    Rgb ink, paper;
};
constexpr Colors darkOnLight{{26, 26, 26}, {255, 255, 255}}, lightOnDark{{232, 234, 236}, {14, 17, 20}};
// Solid enough for the ink to be read over anything; thin enough that the picture is seen behind it.
constexpr unsigned paperAlpha = 204;
constexpr double widestShare = 0.4;  // The bar never takes more of the picture's width than this.
// The bar takes this share of the picture's height. A fitted view mostly leaves so much free in its corner.
constexpr double barShare = 0.36;

struct Box {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Where everything goes, in pixels.
struct Layout {
    double em = 0;  ///< Text size; all distances are in proportion.
    bool labelled = false;
    Box panel, bar;
    int line = 1;  ///< Thickness of outline and ticks.
    int tickLength = 0;
    int labelX = 0;
    int titleBaseline = 0, factorBaseline = 0;
    std::string title;
};

int rounded(double value)
{
    return int(std::floor(value + 0.5));
}

Layout layOut(const PictureRows& picture, double em, const Ticks& ticks, const std::string& title,
              const TextPainter& text, bool labelled)
{
    Layout layout;
    layout.em = em;
    layout.labelled = labelled;
    layout.line = std::max(1, rounded(em / 16));
    layout.tickLength = labelled ? rounded(0.4 * em) : 0;
    layout.bar.width = rounded(1.2 * em);
    layout.bar.height = rounded(barShare * picture.height);

    const int padding = rounded(0.85 * em), margin = rounded(0.9 * em), gap = rounded(0.4 * em);
    const int lineHeight = rounded(1.45 * em);
    double contentWidth = layout.bar.width;
    int header = 0;
    if (labelled) {
        double labelWidth = text.widthPx(ticks.factor);
        for (const std::string& label : ticks.labels) labelWidth = std::max(labelWidth, text.widthPx(label));
        contentWidth += layout.tickLength + gap + labelWidth;
        layout.title =
            text.fitted(title, std::min(std::max(contentWidth, 10 * em), widestShare * picture.width - 2 * padding));
        contentWidth = std::max(contentWidth, text.widthPx(layout.title));
        const int lines = (layout.title.empty() ? 0 : 1) + (ticks.factor.empty() ? 0 : 1);
        header = lines == 0 ? 0 : lines * lineHeight + rounded(0.5 * em);
    }
    layout.panel.width = int(std::ceil(contentWidth)) + 2 * padding;
    layout.panel.height = layout.bar.height + header + 2 * padding;
    layout.panel.x = picture.width - margin - layout.panel.width;
    layout.panel.y = margin;
    layout.bar.x = layout.panel.x + padding;
    layout.bar.y = layout.panel.y + padding + header;
    layout.labelX = layout.bar.x + layout.bar.width + layout.tickLength + gap;
    layout.titleBaseline = layout.panel.y + padding + rounded(0.85 * em);
    layout.factorBaseline = layout.titleBaseline + (layout.title.empty() ? 0 : lineHeight);
    return layout;
}

bool fits(const Layout& layout, const PictureRows& picture)
{
    return layout.panel.y + layout.panel.height <= picture.height && layout.panel.width <= widestShare * picture.width;
}

void fillRect(const PictureRows& picture, const Box& box, const Rgb& color, unsigned alpha = 255)
{
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) blendPixel(picture, x, y, color, alpha);
}

/// A rectangle with round, antialiased corners.
void drawPanel(const PictureRows& picture, const Box& box, double radius, const Rgb& paper)
{
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) {
            const double inX = std::max(0.0, radius - std::min(x + 0.5, box.width - x - 0.5));
            const double inY = std::max(0.0, radius - std::min(y + 0.5, box.height - y - 0.5));
            const double outside = std::sqrt(inX * inX + inY * inY) - radius;
            const double coverage = std::clamp(0.5 - outside, 0.0, 1.0);
            blendPixel(picture, box.x + x, box.y + y, paper, unsigned(rounded(coverage * paperAlpha)));
        }
}

void drawGradient(const PictureRows& picture, const Box& bar, const ColorTable& colors, int line, const Rgb& ink)
{
    fillRect(picture, {bar.x - line, bar.y - line, bar.width + 2 * line, bar.height + 2 * line}, ink);
    for (int y = 0; y < bar.height; ++y) {
        const double t = 1 - (y + 0.5) / bar.height;
        const std::size_t entry = std::size_t(std::clamp(int(t * 256), 0, 255));
        fillRect(picture, {bar.x, bar.y + y, bar.width, 1}, colors[entry]);
    }
}

void drawTicks(const PictureRows& picture, const Layout& layout, const Ticks& ticks, double lo, double hi,
               const TextPainter& text, const Rgb& ink)
{
    const Box& bar = layout.bar;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        // Halves, so that the widest ranges do not overflow.
        const double t = hi > lo ? (ticks.values[i] / 2 - lo / 2) / (hi / 2 - lo / 2) : 0;
        const double y = bar.y + (1 - t) * bar.height;
        // At the ends the tick continues the outline.
        const int row = std::clamp(rounded(y - 0.5 * layout.line), bar.y - layout.line, bar.y + bar.height);
        fillRect(picture, {bar.x + bar.width, row, layout.tickLength, layout.line}, ink);
        const int baseline = rounded(row + 0.5 * layout.line + 0.5 * text.digitHeightPx());
        text.draw(picture, layout.labelX, baseline, ticks.labels[i], ink);
    }
}

}  // namespace

BarInks barInksFor(const std::string& background)
{
    if (background.size() != 6) return BarInks::dark;  // A transparent picture is mostly put on paper.
    const unsigned long rgb = std::stoul(background, nullptr, 16);
    const double luma = 0.2126 * double(rgb >> 16) + 0.7152 * double(rgb >> 8 & 255) + 0.0722 * double(rgb & 255);
    return luma < 96 ? BarInks::light : BarInks::dark;
}

void drawScalarBar(const PictureRows& picture, const ColorTable& colors, double lo, double hi, const std::string& title,
                   BarInks inks)
{
    if (!std::isfinite(lo) || !std::isfinite(hi) || picture.height < 64) return;
    const double em = std::max(10.0, 5 + 0.0125 * std::min(picture.width, picture.height));
    const TextPainter text(em);
    const int most = std::clamp(int(barShare * picture.height / (2.75 * em)), 3, 7);
    const Ticks ticks = niceTicks(lo, hi, most);

    Layout layout = layOut(picture, em, ticks, title, text, picture.height >= 160);
    if (layout.labelled && !fits(layout, picture)) layout = layOut(picture, em, ticks, title, text, false);
    if (!fits(layout, picture)) return;

    const auto& [ink, paper] = inks == BarInks::dark ? darkOnLight : lightOnDark;
    drawPanel(picture, layout.panel, 0.5 * em, paper);
    drawGradient(picture, layout.bar, colors, layout.line, ink);
    if (!layout.labelled) return;
    drawTicks(picture, layout, ticks, lo, hi, text, ink);
    text.draw(picture, layout.bar.x - layout.line, layout.titleBaseline, layout.title, ink);
    text.draw(picture, layout.labelX, layout.factorBaseline, ticks.factor, ink);
}

}  // namespace aeolic
