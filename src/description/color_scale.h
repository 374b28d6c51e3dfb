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

/// The scale of that name. Any other text gives the linear scale: validate() has refused it before.
ColorScale colorScaleOf(std::string_view text);

/// Whether a logarithmic scale is asked for, and for neither a range nor data that have one: nothing is above 0. The
/// colours are on a linear scale then.
bool lacksLogarithm(const ShadingOptions& shading, const std::array<double, 2>& dataRange);

/// The scale that these data are shown on.
ColorScale shownScale(const ShadingOptions& shading, const std::array<double, 2>& dataRange);

/// The values at the ends of the colour map: those asked for, else `dataRange`. With a logarithmic scale a low end of
/// the data that is not above 0 becomes a thousandth of the high end.
std::array<double, 2> shownRange(const ShadingOptions& shading, const std::array<double, 2>& dataRange);

}  // namespace aeolic
