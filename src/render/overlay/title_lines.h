#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/overlay/drawn_text.h"

namespace aeolic {

/// A title in lines that fit `widestPx`: one where it fits, else two, broken at a space, but not within brackets, so
/// that a unit stays whole. The break is where the wider line is narrowest. What two lines do not hold ends in an
/// ellipsis; a unit at the end, in brackets, is kept all the same. None where there is no title, or no room for a
/// letter.
std::vector<std::string> titleLines(std::string_view title, double widestPx, const TextPainter& text);

}  // namespace aeolic
