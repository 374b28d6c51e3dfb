#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/color_scale.h"
#include "description/colormap.h"
#include "render/overlay/panel.h"
#include "render/overlay/ticks.h"

namespace aeolic {

/// What fills a bar: colours, or streaks that fade or get shorter towards the low end.
enum class BarFill { colors, fadingStreaks, shorterStreaks };

/// What a colour bar tells.
struct ScalarBar {
    std::vector<Color> colors;  ///< From the low end to the high one, in equal parts of the bar: the surface's own.
    double lo = 0, hi = 1;      ///< The range, lo <= hi; with a logarithmic scale lo > 0.
    ColorScale scale;
    std::string title;                  ///< UTF-8; a long one takes two lines, or ends in an ellipsis.
    std::optional<Color> below, above;  ///< Shown beyond the ends where they are set.
    BarFill fill = BarFill::colors;     ///< Of streaks: one colour stands in `colors`, their mean.
};

/// A bar with its title and tick values, laid out for a picture, in a panel that may be put anywhere in it.
class ScalarBarLayout {
public:
    /// For a picture of that size, in which it may take `highest` rows. `em`: the size of its text, pixels. Where it
    /// has no room with its labels, or the range is not finite, `width` and `height` are 0. If lo == hi, the one value
    /// is labelled at the low end: the surface then has that end's colour.
    ScalarBarLayout(const ScalarBar& bar, double em, int pictureWidth, int pictureHeight, int highest);

    int width = 0, height = 0;  ///< Of the panel, in pixels.

    /// Draws what of it lies in these rows, with the panel's upper left corner at that pixel. The pixels are the same
    /// on every run and machine. Cost: about a millisecond.
    void draw(const PictureRows& picture, int x, int y, Inks inks) const;

private:
    /// A bar as high as its share of the picture, or lower where it may take `highest` rows. Whether it has room so.
    bool fit(int pictureWidth, int pictureHeight, int highest, int mostLines);
    /// Everything around a bar of box_.height.
    void layOut(int pictureWidth, int mostLines);
    void drawColors(const PictureRows& picture, const Box& box, const Rgb& ink) const;
    void drawStreaks(const PictureRows& picture, const Box& box) const;
    void drawTicks(const PictureRows& picture, const Box& box, const TextPainter& text, const Rgb& ink) const;

    ScalarBar bar_;
    Ticks ticks_;
    std::vector<std::string> title_;  // In lines.
    double em_ = 0;
    Box box_;  // The bar's own, within the panel.
    int line_ = 1, tickLength_ = 0, end_ = 0, labelX_ = 0, titleBaseline_ = 0, lineHeight_ = 0;
};

}  // namespace aeolic
