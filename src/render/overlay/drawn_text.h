#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "render/tile.h"

namespace aeolic {

using Rgb = std::array<std::uint8_t, 3>;

/// Puts `color` over one pixel with opacity `alpha` (0 to 255). Outside the rows nothing happens.
void blendPixel(const PictureRows& picture, int x, int y, const Rgb& color, unsigned alpha);

/// Text in the embedded font, unhinted and antialiased: the same pixels everywhere. Not thread-safe.
class TextPainter {
public:
    /// `sizePx`: the em square, at least 1.
    explicit TextPainter(double sizePx);
    ~TextPainter();

    /// Width of UTF-8 text in pixels. What is not UTF-8, and control characters, count as U+FFFD.
    double widthPx(std::string_view text) const;

    /// Height of a digit, for centring numbers on a line.
    double digitHeightPx() const;

    /// The characters of UTF-8 text that the font has no picture of, each once, as UTF-8. They are drawn as boxes.
    std::string unknownIn(std::string_view text) const;

    /// `text`, or as much of its beginning as fits `widestPx` with an ellipsis after it; empty if not even that fits.
    std::string fitted(std::string_view text, double widestPx) const;

    /// Draws with the pen starting at pixel `x` (a fraction is honoured) on the row `baseline`.
    void draw(const PictureRows& picture, double x, int baseline, std::string_view text, const Rgb& color) const;

private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace aeolic
