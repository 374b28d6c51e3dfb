#pragma once

/// How values are spread over a colour map.

#include <array>
#include <string_view>

#include "aeolic/scene_description.h"

namespace aeolic {

struct ColorScale {
    enum class Kind { linear, log, bands };

    Kind kind = Kind::linear;
    int bands = 0;  ///< Of Kind::bands alone: how many, [2, 256].
};

inline constexpr std::array<std::string_view, 2> colorScaleNames{"linear", "log"};

/// Whether that is bands:N with an N that a colour map has colours for. `bandsPattern` is a regular expression for the
/// same.
bool isBands(std::string_view text);
inline constexpr const char* bandsPattern = "^bands:([2-9]|[1-9][0-9]|1[0-9][0-9]|2[0-4][0-9]|25[0-6])$";
inline constexpr const char* bandsText = "bands:N, N from 2 to 256";

/// The scale of that name. What is none is linear: validate() has refused it.
ColorScale colorScaleOf(std::string_view text);

/// The values at the ends of the colour map: those asked for, else `dataRange`. With a logarithmic scale a low end of
/// the data that is not above 0 becomes a thousandth of the high end. Where that is not above 0 either, they are 0.001
/// and 1, and all values lie below.
std::array<double, 2> shownRange(const ShadingOptions& shading, const std::array<double, 2>& dataRange);

}  // namespace aeolic
