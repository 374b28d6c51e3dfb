#include "data/color_map/color_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "data/color_map/color_spaces.h"
#include "description/option_rules.h"

namespace aeolic {
namespace {

void requireSound(const ColorPoints& map, const std::string& path)
{
    for (std::size_t i = 0; i < map.points.size(); ++i) {
        const std::string where = fmt::format("{}: point {}", path, i + 1);
        if (!std::isfinite(map.points[i].place)) throw InputError(where, "its value is not finite", "a number");
        colorOfParts(where, map.points[i].rgb);
    }
}

}  // namespace

ColorSpace colorSpaceNamed(const std::string& where, const std::string& name)
{
    static const std::vector<std::string> names{"RGB", "HSV", "Wrapped", "Lab", "CIELAB", "Diverging"};
    constexpr ColorSpace spaces[] = {ColorSpace::rgb, ColorSpace::hsv, ColorSpace::hsvWrapped,
                                     ColorSpace::lab, ColorSpace::lab, ColorSpace::diverging};
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw InputError(where, "found " + inQuotes(name),
                         fmt::format("one of {}", fmt::join(names, ", ")) + didYouMean(name, names));
    return spaces[found - names.begin()];
}

Color colorOfParts(const std::string& where, const std::array<double, 3>& rgb)
{
    Color color{};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(rgb[c] >= 0 && rgb[c] <= 1))
            throw InputError(where, fmt::format("found a colour of {}", numberText(rgb[c])), "parts from 0 to 1");
        color[c] = std::uint8_t(std::lround(255 * rgb[c]));
    }
    return color;
}

ColorMap colorMapOf(ColorPoints map, const std::string& path)
{
    requireSound(map, path);
    auto& points = map.points;
    std::ranges::stable_sort(points, {}, &ColorPoints::Point::place);
    if (points.empty() || !(points.front().place < points.back().place))
        throw InputError(
            path,
            points.size() < 2
                ? fmt::format("found {} point{}", points.size(), points.size() == 1 ? "" : "s")
                : fmt::format("found {} points, all at {}", points.size(), numberText(points.front().place)),
            "a colour map: colours at two values or more");
    ColorMap out{{}, map.nan, map.below, map.above};
    const double lo = points.front().place, hi = points.back().place;
    std::size_t next = 1;  // The first point beyond the place, so that the later of two at one place counts there.
    for (std::size_t i = 0; i < out.colors.size(); ++i) {
        const double part = double(i) / double(out.colors.size() - 1);
        const double place = i + 1 == out.colors.size() ? hi : lo * (1 - part) + hi * part;
        while (next + 1 < points.size() && points[next].place <= place) ++next;
        const auto &a = points[next - 1], &b = points[next];
        const double width = b.place / 2 - a.place / 2;  // Halves, so that the widest maps do not overflow.
        const double t = width > 0 ? std::clamp((place / 2 - a.place / 2) / width, 0.0, 1.0) : 1.0;
        out.colors[i] = between(a.rgb, b.rgb, t, map.space);
    }
    return out;
}

}  // namespace aeolic
