#include "engine/tile_picture.h"

#include <utility>

#include "description/colormap.h"
#include "render/overlay/scalar_bar.h"

namespace aeolic {
namespace {

/// A picture as wide as `tile`, whose pixels it will hold.
Picture emptyPicture(const Tile& tile, int rows, Picture kept)
{
    Picture picture{tile.extent.width(), rows, channelsOn(tile.background), std::move(kept.pixels)};
    picture.pixels.resize(std::size_t(picture.width) * std::size_t(rows) * std::size_t(picture.channels));
    return picture;
}

void addScalarBar(const PictureRows& rows, const ShadingOptions& shading, const Scene& scene)
{
    if (!scene.hasScalar || !shading.scalarBar) return;
    const auto range = shading.colorRange.value_or(scene.scalarRange);
    drawScalarBar(rows, colorMap(shading.colorMap), range[0], range[1], scene.scalarName,
                  barInksFor(shading.background));
}

}  // namespace

Picture gatheredPicture(const FrameTiles& tiles, int height, Picture kept)
{
    Picture picture = emptyPicture(tiles.stripe, height, std::move(kept));
    layOut(tiles.stripe, picture);
    for (const PaintedPixels& rows : tiles.others) layOut(rows, picture);
    return picture;
}

Picture pictureOf(const FrameTiles& tiles, int height, const ShadingOptions& shading, const Scene& scene, Picture kept)
{
    Picture picture = gatheredPicture(tiles, height, std::move(kept));
    addScalarBar(picture, shading, scene);
    return picture;
}

Picture pictureOf(const Tile& stripe, int height, const ShadingOptions& shading, const Scene& scene, Picture kept)
{
    Picture picture = emptyPicture(stripe, stripe.extent.height(), std::move(kept));
    const PictureRows rows(picture, height, stripe.extent.y0);
    layOut(stripe, rows);
    addScalarBar(rows, shading, scene);
    return picture;
}

}  // namespace aeolic
