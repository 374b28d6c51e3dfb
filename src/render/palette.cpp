#include "render/palette.h"

#include "description/colormap.h"

namespace aeolic {

Palette makePalette(const ShadingOptions& shading, bool hasScalar, const std::array<double, 2>& dataRange)
{
    Palette palette;
    palette.contrast = float(shading.contrast);
    palette.blend = float(shading.blend);
    palette.lighting = shading.lighting;
    palette.useScalar = hasScalar;
    if (hasScalar) {
        const ColorTable& colors = colorMap(shading.colorMap);
        for (std::size_t i = 0; i < palette.table.size(); ++i)
            palette.table[i] =
                std::uint32_t(colors[i][0]) | std::uint32_t(colors[i][1]) << 8 | std::uint32_t(colors[i][2]) << 16;
        const auto range = shading.colorRange.value_or(dataRange);
        palette.scalarLo = float(range[0]);
        palette.entriesPerScalar = range[1] > range[0] ? float(256.0 / (range[1] - range[0])) : 0.0f;
    }
    if (shading.background == "transparent") {
        palette.background = {255, 255, 255, 0};
    } else {
        const unsigned long rgb = std::stoul(shading.background, nullptr, 16);
        palette.background = {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb), 255};
    }
    return palette;
}

}  // namespace aeolic
