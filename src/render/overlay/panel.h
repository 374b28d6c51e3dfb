#pragma once

#include <string>

#include "render/overlay/drawn_text.h"

namespace aeolic {

/// Pixels of a picture: columns from x, rows from y.
struct Box {
    int x = 0, y = 0, width = 0, height = 0;

    int right() const { return x + width; }
    int bottom() const { return y + height; }
    bool operator==(const Box&) const = default;
};

/// Dark ink on light panels, or light ink on dark ones.
enum class Inks { dark, light };

/// The colours of text and lines, and of the panels behind them.
struct InkColors {
    Rgb ink, paper;
};
InkColors colorsOf(Inks inks);

/// The inks that can be read on a background, which is RRGGBB or "transparent".
Inks inksFor(const std::string& background);

/// The nearest whole number, halves upwards.
int wholePx(double value);

/// Fills what of the box lies in these rows.
void fillBox(const PictureRows& picture, const Box& box, const Rgb& color);

/// A translucent rectangle with round, antialiased corners: what stands on it can be read over anything, and the
/// picture is seen behind it. Its opacity is kPanelAlpha.
inline constexpr unsigned kPanelAlpha = 204;
void drawPanel(const PictureRows& picture, const Box& box, double radius, const Rgb& paper);

}  // namespace aeolic
