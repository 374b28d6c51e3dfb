#pragma once

#include <string>

#include "description/colormap.h"
#include "render/tile.h"

namespace aeolic {

/// What the bar is drawn with: dark on a light backing, or light on a dark one.
enum class BarInks { dark, light };

/// What reads on a background: RRGGBB or "transparent".
BarInks barInksFor(const std::string& background);

/// Draws the part in these rows of a colour bar with its title and round tick values into the top right of a finished
/// picture (RGB or RGBA), on a translucent backing so that it reads over anything. Sizes follow the picture's; below
/// 160 pixels of height the labels go, below 64 there is no bar. `lo <= hi`; with lo == hi the one value is labelled at
/// the low end, whose colour the surface then has; a range that is not finite draws nothing. `title` is UTF-8 and is
/// shortened with an ellipsis. The same pixels on every run and machine. Cost: about a millisecond.
void drawScalarBar(const PictureRows& picture, const ColorTable& colors, double lo, double hi, const std::string& title,
                   BarInks inks = BarInks::dark);

}  // namespace aeolic
