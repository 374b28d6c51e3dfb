#include "render/overlay/panel.h"

#include <algorithm>
#include <cmath>

#include "description/colormap.h"

namespace aeolic {

InkColors colorsOf(Inks inks)
{
    constexpr InkColors darkOnLight{{26, 26, 26}, {255, 255, 255}}, lightOnDark{{232, 234, 236}, {14, 17, 20}};
    return inks == Inks::dark ? darkOnLight : lightOnDark;
}

Inks inksFor(const std::string& background)
{
    if (background.size() != 6) return Inks::dark;  // A transparent picture is mostly put on paper.
    const Color color = colorOf(background);
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2] < 96 ? Inks::light : Inks::dark;
}

int wholePx(double value)
{
    return int(std::floor(value + 0.5));
}

void fillBox(const PictureRows& picture, const Box& box, const Rgb& color)
{
    for (int y = box.y; y < box.bottom(); ++y)
        for (int x = box.x; x < box.right(); ++x) blendPixel(picture, x, y, color, 255);
}

void drawPanel(const PictureRows& picture, const Box& box, double radius, const Rgb& paper)
{
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) {
            const double inX = std::max(0.0, radius - std::min(x + 0.5, box.width - x - 0.5));
            const double inY = std::max(0.0, radius - std::min(y + 0.5, box.height - y - 0.5));
            const double outside = std::sqrt(inX * inX + inY * inY) - radius;
            const double coverage = std::clamp(0.5 - outside, 0.0, 1.0);
            blendPixel(picture, box.x + x, box.y + y, paper, unsigned(wholePx(coverage * kPanelAlpha)));
        }
}

}  // namespace aeolic
