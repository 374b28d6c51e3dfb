#pragma once

#include <array>
#include <cstdint>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The colours that streaks give one colour of a surface: from the darkest streak by the colour itself to the brightest
/// (shading_model.h). Bytes R, G, B from the lowest; the highest byte of `base` is the knee.
struct StreakColors {
    std::uint32_t base = 0, dark = 0, bright = 0;
};

/// The colours of a picture, resolved once per frame for the blending stage of any backend.
struct Palette {
    static constexpr std::size_t kEntries = 256, kMasked = 256;  ///< One more: where the scalar is masked.
    /// [kEntries + 1]; entry 0 for the lowest scalar. Apart, so that shaders and vectors look up one word each.
    std::array<std::uint32_t, kEntries + 1> base{}, dark{}, bright{};
    bool useScalar = false;                    ///< false: the plain surface.
    float scalarLo = 0, entriesPerScalar = 0;  ///< Entry = (scalar - lo) * entriesPerScalar, clamped to 0 to 255.
    float contrast = 1, blend = 1;
    bool lighting = true;
    bool antialias = false;                                      ///< Edges are smoothed (antialias.h).
    std::array<std::uint8_t, 4> background{255, 255, 255, 255};  ///< RGBA.
};

/// The streaks' colours around an sRGB colour. `blend`: 0 none, 1 the strongest. Hue stays, and chroma but where sRGB
/// has no such colour. Streaks of even tone have the colour itself for their mean: with the default blend half of each
/// map's to within two units of CIEDE2000, and all to within four. Source: Ottosson, A perceptual color space for image
/// processing (2020).
StreakColors streakColors(const std::array<std::uint8_t, 3>& color, double blend);

/// `dataRange` is used where the options give no range. Throws InputError for an unknown colour map.
Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange);

}  // namespace aeolic
