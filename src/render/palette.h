#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "aeolic/scene_description.h"
#include "data/scene.h"
#include "description/colormap.h"

namespace aeolic {

/// The colours that streaks give one colour of a surface: from the darkest streak by the colour itself to the brightest
/// (shading_model.h). Bytes R, G, B from the lowest; the highest byte of `base` is the knee.
struct StreakColors {
    std::uint32_t base = 0, dark = 0, bright = 0;
};

/// What a scalar's colours are.
struct ScalarColors {
    /// Three entries more: where the scalar is masked, below the range, above it.
    static constexpr std::size_t kEntries = 256, kMasked = 256, kBelow = 257, kAbove = 258, kAll = 259;
    /// [kAll]; entry 0 for the lowest scalar. Apart, so that shaders and vectors look up one word each.
    std::array<std::uint32_t, kAll> base{}, dark{}, bright{};
    float scalarLo = 0, scalarHi = 1;  ///< The range.
    /// Smaller and larger values have the colours beyond the range. The limits are the range's ends where options give
    /// the range; else they are a hair outside of the data's own ends, because interpolation rounds.
    float lowest = 0, highest = 1;
    /// Within the range, entry = (scalar - lo) * entriesPerScalar, clamped to 0 to lastEntry.
    float entriesPerScalar = 0, lastEntry = 255;
    /// With a logarithmic scale: the entry is the last whose edge is not above the scalar. A search gives the same on
    /// every machine; a logarithm would not.
    bool searched = false;
    std::array<float, kEntries> edges{};  ///< Where entries begin, ascending.
};

/// The colours of a picture, resolved once per frame for the blending stage of any backend. The table that it is itself
/// is that of a scene of one surface.
struct Palette : ScalarColors {
    bool useScalar = false;  ///< false: the plain surface.
    /// Several surfaces: by the G-buffer's `colors` (surface_mark.h); that of plain surfaces is not used. Else empty.
    std::vector<ScalarColors> tables;
    float contrast = 1, blend = 1;
    bool lighting = true;
    bool antialias = false;                                      ///< Edges are smoothed (antialias.h).
    bool occlusion = false;                                      ///< Hollows are darker (occlusion.h).
    std::array<std::uint8_t, 4> background{255, 255, 255, 255};  ///< RGBA.
};

/// The streaks' colours around an sRGB colour. `blend`: 0 none, 1 the strongest. Hue stays, and chroma but where sRGB
/// has no such colour. Streaks of even tone have the colour itself for their mean: with the default blend half of each
/// map's to within two units of CIEDE2000, and all to within four. Source: Ottosson, A perceptual color space for image
/// processing (2020).
StreakColors streakColors(const std::array<std::uint8_t, 3>& color, double blend);

/// The colours from the low end of the range to the high one: 256, or as many as there are bands.
std::vector<Color> shownColors(const ShadingOptions& shading, const ColorMap& map);

/// `dataRange` is used where the options give no range.
Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange,
                    const ColorMap& map);

/// For several surfaces: `colors` are the scene's, `maps` their colour maps; none, or null: those built in.
Palette makePalette(const ShadingOptions& shading, const std::vector<SceneColors>& colors,
                    const std::vector<std::shared_ptr<const ColorMap>>& maps);

/// The shading options of some of several surfaces: what they do not say themselves stays.
ShadingOptions shadingOf(const ShadingOptions& shading, const SceneColors& colors);

/// The same where the colour map is built in. Throws InputError for an unknown one.
Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange);

}  // namespace aeolic
