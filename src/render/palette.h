#pragma once

#include <array>
#include <cstdint>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The colours of a picture, resolved once per frame for the blending stage of any backend.
struct Palette {
    std::array<std::uint32_t, 256> table{};    ///< Little-endian R, G, B, 0; entry 0 for the lowest scalar.
    bool useScalar = false;                    ///< false: the plain surface.
    float scalarLo = 0, entriesPerScalar = 0;  ///< Entry = (scalar - lo) * entriesPerScalar, clamped to 0 to 255.
    float contrast = 1, blend = 1;
    bool lighting = true;
    std::array<std::uint8_t, 4> background{255, 255, 255, 255};  ///< RGBA.
};

/// `dataRange` is used where the options give no range. Throws InputError for an unknown colour map.
Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange);

}  // namespace aeolic
