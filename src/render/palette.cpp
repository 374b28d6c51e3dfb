#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/color_map/color_spaces.h"
#include "description/color_scale.h"
#include "render/shading_model.h"
#include "render/surface_mark.h"

namespace aeolic {
namespace {

using Triple = ColorTriple;

/// sRGB in [0, 1] to Oklab: lightness, green to red, blue to yellow.
Triple oklabOf(const Triple& rgb)
{
    constexpr double cones[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                    {0.2119034982, 0.6806995451, 0.1073969566},
                                    {0.0883024619, 0.2817188376, 0.6299787005}};
    constexpr double lab[3][3] = {{0.2104542553, 0.7936177850, -0.0040720468},
                                  {1.9779984951, -2.4285922050, 0.4505937099},
                                  {0.0259040371, 0.7827717662, -0.8086757660}};
    Triple lms = times(cones, {linearOfSrgb(rgb[0]), linearOfSrgb(rgb[1]), linearOfSrgb(rgb[2])});
    for (double& v : lms) v = std::cbrt(v);
    return times(lab, lms);
}

/// Outside of [0, 1] where sRGB has no such colour.
Triple rgbOf(const Triple& lab)
{
    constexpr double cones[3][3] = {
        {1, 0.3963377774, 0.2158037573}, {1, -0.1055613458, -0.0638541728}, {1, -0.0894841775, -1.2914855480}};
    constexpr double rgb[3][3] = {{4.0767416621, -3.3077115913, 0.2309699292},
                                  {-1.2684380046, 2.6097574011, -0.3413193965},
                                  {-0.0041960863, -0.7034186147, 1.7076147010}};
    Triple lms = times(cones, lab);
    for (double& v : lms) v = v * v * v;
    Triple out = times(rgb, lms);
    for (double& v : out) v = v < 0 ? v : srgbOfLinear(v);
    return out;
}

bool isShown(const Triple& rgb)
{
    constexpr double rounding = 1e-3;
    return std::all_of(rgb.begin(), rgb.end(), [](double v) { return v >= -rounding && v <= 1 + rounding; });
}

/// The colour as far from `lab` as sRGB has colours, at most `lightness` lighter. Meanwhile chroma may fade a little,
/// because there are no bright colours as rich as some middling ones.
Triple lighter(const Triple& lab, double lightness)
{
    const auto at = [&](double part) {
        const double chroma = 1 - shading::kStreakFade * part;
        return rgbOf({lab[0] + part * lightness, lab[1] * chroma, lab[2] * chroma});
    };
    double shown = 0, beyond = 1;
    if (isShown(at(1))) return at(1);
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (shown + beyond);
        (isShown(at(middle)) ? shown : beyond) = middle;
    }
    return at(shown);
}

std::uint32_t wordOf(const Triple& rgb)
{
    std::uint32_t word = 0;
    for (std::size_t c = 0; c < 3; ++c)
        word |= std::uint32_t(std::lround(255 * std::clamp(rgb[c], 0.0, 1.0))) << (8 * c);
    return word;
}

}  // namespace

StreakColors streakColors(const std::array<std::uint8_t, 3>& color, double blend)
{
    const Triple base{color[0] / 255.0, color[1] / 255.0, color[2] / 255.0}, lab = oklabOf(base);
    Triple dark = lighter(lab, -shading::kStreakLightness * blend),
           bright = lighter(lab, shading::kStreakLightness * blend);
    // Tones from -1 to the knee go from dark to base, those above to bright. The knee brings their mean as near to the
    // base as it can, and both ends move by what remains.
    double along = 0, squared = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        along += (bright[c] + dark[c] - 2 * base[c]) * (bright[c] - dark[c]);
        squared += (bright[c] - dark[c]) * (bright[c] - dark[c]);
    }
    const double wanted = squared > 0 ? std::clamp(along / squared, -shading::kMostKnee, shading::kMostKnee) : 0;
    const auto level = std::uint32_t(std::lround(shading::kKneeZero + wanted * shading::kKneeZero));
    const double knee = level / double(shading::kKneeZero) - 1;
    for (std::size_t c = 0; c < 3; ++c) {
        const double off = ((1 - knee) * (bright[c] - base[c]) + (1 + knee) * (dark[c] - base[c])) / 4;
        dark[c] -= 2 * off;
        bright[c] -= 2 * off;
        // A fifth of what one end cannot move any more, the other moves instead: all of it would leave no streaks.
        const double tooDark = std::min(dark[c], 0.0), tooBright = std::max(bright[c] - 1, 0.0);
        bright[c] += 0.2 * tooDark * (1 + knee) / (1 - knee);
        dark[c] += 0.2 * tooBright * (1 - knee) / (1 + knee);
    }
    return {wordOf(base) | level << 24, wordOf(dark), wordOf(bright)};
}

std::vector<Color> shownColors(const ShadingOptions& shading, const ColorMap& map)
{
    const ColorScale scale = colorScaleOf(shading.colorScale);
    if (scale.kind != ColorScale::Kind::bands) return {map.colors.begin(), map.colors.end()};
    std::vector<Color> colors;
    colors.reserve(std::size_t(scale.bands));
    for (int i = 0; i < scale.bands; ++i)  // The first and the last keep the map's own ends.
        colors.push_back(map.colors[std::size_t(std::lround(i * 255.0 / (scale.bands - 1)))]);
    return colors;
}

namespace {

/// Where the entries of a logarithmic scale begin.
std::array<float, ScalarColors::kEntries> edgesOf(double lo, double hi)
{
    std::array<float, ScalarColors::kEntries> edges{};
    for (std::size_t i = 0; i < edges.size(); ++i)
        edges[i] = float(lo * std::pow(hi / lo, double(i) / double(edges.size())));
    return edges;
}

void addColors(const ShadingOptions& shading, const ColorMap& map, bool hasWidth, ScalarColors& palette)
{
    const std::vector<Color> colors = shownColors(shading, map);
    const auto set = [&](std::size_t entry, const Color& color) {
        const StreakColors streaks = streakColors(color, shading.blend);
        palette.base[entry] = streaks.base;
        palette.dark[entry] = streaks.dark;
        palette.bright[entry] = streaks.bright;
    };
    const auto chosen = [](const std::string& own, const std::optional<Color>& ofFile, const Color& otherwise) {
        return own.empty() ? ofFile.value_or(otherwise) : colorOf(own);
    };
    for (std::size_t i = 0; i < colors.size(); ++i) set(i, colors[i]);
    set(ScalarColors::kMasked, chosen(shading.nanColor, map.nan, shading::kMaskedColor));
    set(ScalarColors::kBelow, chosen(shading.belowColor, map.below, colors.front()));
    // Where the range has no width all of the surface has the lowest colour.
    set(ScalarColors::kAbove, chosen(shading.aboveColor, map.above, hasWidth ? colors.back() : colors.front()));
    palette.lastEntry = float(colors.size() - 1);
}

ScalarColors tableOf(const ShadingOptions& shading, const std::array<double, 2>& dataRange, const ColorMap& map)
{
    ScalarColors table;
    const auto range = shownRange(shading, dataRange);
    const bool hasWidth = range[1] > range[0];
    addColors(shading, map, hasWidth, table);
    table.scalarLo = float(range[0]);
    table.scalarHi = float(range[1]);
    const bool isWhole = !shading.colorRange && shading.colorRangeOf == RangeOf::data;
    const double hair = !isWhole ? 0 : 1e-5 * std::max(std::abs(range[0]), std::abs(range[1]));
    table.lowest = float(range[0] - hair);
    table.highest = float(range[1] + hair);
    // Ranges narrower than float tells have a finite number, too: 0 times it is the lowest entry.
    table.entriesPerScalar = hasWidth ? float(std::min((double(table.lastEntry) + 1) / (range[1] - range[0]),
                                                       double(std::numeric_limits<float>::max())))
                                      : 0.0f;
    table.searched = hasWidth && shownScale(shading, dataRange).kind == ColorScale::Kind::log;
    if (table.searched) table.edges = edgesOf(range[0], range[1]);
    return table;
}

/// The gray of surfaces for orientation, whatever the scalar is.
ScalarColors contextTable()
{
    const std::uint32_t gray = wordOf({shading::kContext, shading::kContext, shading::kContext});
    ScalarColors table;
    table.base.fill(gray | shading::kKneeZero << 24);
    table.dark.fill(gray);
    table.bright.fill(gray);
    return table;
}

/// All but the colours of a scalar.
Palette paletteWithoutScalar(const ShadingOptions& shading)
{
    Palette palette;
    palette.contrast = float(shading.contrast);
    palette.blend = float(shading.blend);
    palette.lighting = shading.lighting;
    palette.antialias = shading.antialias;
    palette.occlusion = shading.occlusion && shading.lighting;
    if (shading.background == "transparent") {
        palette.background = {255, 255, 255, 0};
    } else {
        const Color color = colorOf(shading.background);
        palette.background = {color[0], color[1], color[2], 255};
    }
    return palette;
}

}  // namespace

Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange,
                    const ColorMap& map)
{
    Palette palette = paletteWithoutScalar(shading);
    palette.useScalar = hasScalar;
    if (hasScalar) static_cast<ScalarColors&>(palette) = tableOf(shading, dataRange, map);
    return palette;
}

Palette makePalette(const ShadingOptions& shading, const std::vector<SceneColors>& colors,
                    const std::vector<std::shared_ptr<const ColorMap>>& maps)
{
    Palette palette = paletteWithoutScalar(shading);
    palette.useScalar = !colors.empty();
    palette.tables = {ScalarColors{}, contextTable()};
    static_assert(surface_mark::kPlain == 0 && surface_mark::kContext == 1 && surface_mark::kFirstColors == 2);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const ShadingOptions own = shadingOf(shading, colors[i]);
        const bool given = i < maps.size() && maps[i];
        palette.tables.push_back(
            tableOf(own, colors[i].rangeFor(own), given ? *maps[i] : ColorMap{colorMap(own.colormap), {}, {}, {}}));
    }
    return palette;
}

ShadingOptions shadingOf(const ShadingOptions& shading, const SceneColors& colors)
{
    ShadingOptions own = shading;
    if (colors.shownRange) own.colorRange = colors.shownRange;
    if (colors.colorMap) own.colormap = *colors.colorMap;
    if (colors.legend) own.legend = *colors.legend;
    return own;
}

Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange)
{
    return makePalette(shading, hasScalar, dataRange, ColorMap{colorMap(shading.colormap), {}, {}, {}});
}

}  // namespace aeolic
