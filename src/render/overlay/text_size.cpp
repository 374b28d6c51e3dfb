#include "render/overlay/text_size.h"

#include <algorithm>

#include "description/option_table.h"

namespace aeolic {

double textSize(int width, int height)
{
    return std::max(10.0, 5 + 0.0125 * std::min(width, height));
}

double textScaleOfSmaller(double textScale, int smallWidth, int smallHeight, int fullWidth, int fullHeight)
{
    if (smallWidth == fullWidth && smallHeight == fullHeight) return textScale;
    constexpr double readablePx = 7;
    const double shrunk = double(smallWidth) / double(fullWidth);
    const double px = std::max(textScale * textSize(fullWidth, fullHeight) * shrunk, readablePx);
    return std::clamp(px / textSize(smallWidth, smallHeight), options::textScale.lo, textScale);
}

}  // namespace aeolic
