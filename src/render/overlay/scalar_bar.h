#pragma once

#include <string>

#include "description/colormap.h"
#include "render/tile.h"

namespace aeolic {

/// The bar's colours: dark ink on a light backing, or light ink on a dark one.
enum class BarInks { dark, light };

/// The inks that can be read on a background, which is RRGGBB or "transparent".
BarInks barInksFor(const std::string& background);

/// Draws a colour bar with its title and round tick values into the top right of a finished picture (RGB or RGBA). Only
/// the part that lies in these rows is drawn. The bar stands on a translucent backing, so that it can be read over
/// anything. Its size follows the picture's. Pictures less than 160 pixels high get no labels, those less than 64 no
/// bar. `lo <= hi`. If lo == hi, the one value is labelled at the low end: the surface then has that end's colour. A
/// range that is not finite draws nothing. `title` is UTF-8; a long one is shortened with an ellipsis. The pixels are
/// the same on every run and machine. Cost: about a millisecond.
void drawScalarBar(const PictureRows& picture, const ColorTable& colors, double lo, double hi, const std::string& title,
                   BarInks inks = BarInks::dark);

}  // namespace aeolic
