#include "render/overlay/orientation_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace aeolic {
namespace {

constexpr double armShare = 0.26;  // Of the box, so that letters at the ends stay within.

/// A line from the middle of the box to `end`, antialiased; ends are round.
void drawLine(const PictureRows& picture, const glm::dvec2& start, const glm::dvec2& end, double width,
              const Rgb& color)
{
    const glm::dvec2 lo = glm::min(start, end) - width, hi = glm::max(start, end) + width, along = end - start;
    const double length2 = glm::dot(along, along);
    for (int y = int(std::floor(lo.y)); y <= int(std::ceil(hi.y)); ++y)
        for (int x = int(std::floor(lo.x)); x <= int(std::ceil(hi.x)); ++x) {
            const glm::dvec2 from = glm::dvec2(x + 0.5, y + 0.5) - start;
            const double part = length2 > 0 ? std::clamp(glm::dot(from, along) / length2, 0.0, 1.0) : 0.0;
            const double distance = glm::length(from - part * along);
            const double coverage = std::clamp(0.5 * width + 0.5 - distance, 0.0, 1.0);
            blendPixel(picture, x, y, color, unsigned(wholePx(255 * coverage)));
        }
}

}  // namespace

void drawOrientationAxes(const PictureRows& picture, const Box& box, const Orientation& view, double em, Inks inks)
{
    constexpr const char* letters[] = {"x", "y", "z"};
    constexpr std::array<Rgb, 3> onLight{{{200, 30, 45}, {20, 125, 50}, {30, 80, 200}}},
        onDark{{{255, 110, 110}, {95, 210, 120}, {120, 165, 255}}};
    const auto [ink, paper] = colorsOf(inks);
    const auto& colors = inks == Inks::dark ? onLight : onDark;
    drawPanel(picture, box, 0.5 * em, paper);
    const TextPainter text(em);
    const glm::dvec2 middle(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return view.forward[a] > view.forward[b]; });
    for (const int axis : order) {  // An axis' own part of `forward` is how far away its end is.
        const glm::dvec2 direction(view.right[axis], -view.up[axis]);
        const glm::dvec2 end = middle + armShare * box.width * direction;
        const Rgb& color = colors[std::size_t(axis)];
        drawLine(picture, middle, end, std::max(1.5, 0.14 * em), color);
        // An axis that points at the viewer has no direction in the picture: its letter stands beside the others.
        const double length = glm::length(direction);
        const glm::dvec2 outwards = length > 0.05 ? direction / length : glm::dvec2(-0.7, 0.7);
        const glm::dvec2 place = end + 0.68 * em * outwards;
        text.draw(picture, place.x - 0.5 * text.widthPx(letters[axis]), wholePx(place.y + 0.27 * em), letters[axis],
                  color);
    }
}

}  // namespace aeolic
