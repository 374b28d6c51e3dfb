#pragma once

#include <string>
#include <vector>

#include "base/byte_message.h"
#include "description/colormap.h"

namespace aeolic {

/// How colours between two points are found. The names are ParaView's; `diverging` is Moreland's Msh interpolation.
/// `hsvWrapped` goes around the circle of hues the shorter way.
enum class ColorSpace { rgb, hsv, hsvWrapped, lab, diverging };

/// A colour map as a file has it: colours at places.
struct ColorPoints {
    struct Point {
        double place;
        std::array<double, 3> rgb;  ///< sRGB, [0, 1].
    };
    std::vector<Point> points;  ///< In the file's order.
    ColorSpace space = ColorSpace::rgb;
    std::optional<Color> nan, below, above;
};

template <PerhapsConst<ColorPoints> Points, class Visit>
void withMembers(Points& points, const Visit& visit)
{
    visit(points.points, points.space, points.nan, points.below, points.above);
}

/// ParaView's name of a space ("RGB", "HSV", "Wrapped", "Lab", "CIELAB", "Diverging"). Throws InputError, with `where`
/// in front, for another.
ColorSpace colorSpaceNamed(const std::string& where, const std::string& name);

/// An sRGB colour of parts from 0 to 1. Throws InputError, with `where` in front, for parts beyond.
Color colorOfParts(const std::string& where, const std::array<double, 3>& rgb);

/// The 256 colours, from the lowest place to the highest. Points are sorted; where two have the same place the colour
/// jumps there. Throws InputError, with `path` in front, for fewer than two places, and for colours or places that are
/// not finite or out of range.
ColorMap colorMapOf(ColorPoints points, const std::string& path);

}  // namespace aeolic
