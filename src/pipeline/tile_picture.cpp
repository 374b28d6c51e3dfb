#include "pipeline/tile_picture.h"

#include "render/colormap.h"
#include "render/scalar_bar.h"

namespace aeolic {
namespace {

Picture pixelsOf(const Tile& tile, bool withAlpha)
{
    Picture picture{tile.extent.width(), tile.extent.height(), withAlpha ? 4 : 3, {}};
    const std::size_t count = std::size_t(picture.width) * std::size_t(picture.height);
    if (withAlpha) {
        picture.pixels = tile.rgba;
        return picture;
    }
    picture.pixels.resize(count * 3);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c) picture.pixels[3 * i + c] = tile.rgba[4 * i + c];
    return picture;
}

}  // namespace

Picture pictureOf(const Tile& tile, int height, const ShadingOptions& shading, const Scene& scene)
{
    Picture picture = pixelsOf(tile, shading.background == "transparent");
    if (!scene.hasScalar || !shading.scalarBar) return picture;
    const auto range = shading.colorRange.value_or(scene.scalarRange);
    drawScalarBar({picture, height, tile.extent.y0}, colorMap(shading.colorMap), range[0], range[1], scene.scalarName,
                  barInksFor(shading.background));
    return picture;
}

}  // namespace aeolic
