#pragma once

#include <string>

#include "aeolic/picture.h"
#include "render/colormap.h"

namespace aeolic {

/// Draws a colour bar with its title and round tick values over the right side of a finished picture (RGB or RGBA), on
/// a translucent backing so that it reads over anything. Sizes follow the picture's height; below 160 pixels the labels
/// go, below 64 nothing is drawn. `lo <= hi`; with lo == hi one value is labelled, at the middle of the bar; a range
/// that is not finite draws nothing. `title` is UTF-8 and is shortened with an ellipsis. The same pixels on every run
/// and machine. Cost: well under a millisecond for the pixels, about one for the text.
void drawScalarBar(Picture& picture, const ColorTable& colors, double lo, double hi, const std::string& title);

}  // namespace aeolic
