#include "engine/tile_picture.h"

#include <utility>

namespace aeolic {
namespace {

/// A picture as wide as `tile`, whose pixels it will hold.
Picture emptyPicture(const Tile& tile, int rows, Picture kept)
{
    Picture picture{tile.extent.width(), rows, channelsOn(tile.background), std::move(kept.pixels)};
    picture.pixels.resize(std::size_t(picture.width) * std::size_t(rows) * std::size_t(picture.channels));
    return picture;
}

}  // namespace

Picture gatheredPicture(const FrameTiles& tiles, int height, Picture kept)
{
    Picture picture = emptyPicture(tiles.stripe, height, std::move(kept));
    layOut(tiles.stripe, picture);
    for (const PaintedPixels& rows : tiles.others) layOut(rows, picture);
    return picture;
}

DrawnFrame pictureOf(const FrameTiles& tiles, int height, const Figure& figure, std::optional<Corner> steady,
                     const SumOfRanks& sumOfRanks, Picture kept)
{
    const Tile& stripe = tiles.stripe;
    DrawnFrame picture;
    picture.wholeHeight = height;
    picture.firstRow = tiles.gather ? 0 : stripe.extent.y0;
    static_cast<Picture&>(picture) = tiles.gather ? gatheredPicture(tiles, height, std::move(kept))
                                                  : emptyPicture(stripe, stripe.extent.height(), std::move(kept));
    const PictureRows rows(picture, height, picture.firstRow);
    if (!tiles.gather) layOut(stripe, rows);

    const FigureLayout layout(figure, rows.width, height);
    std::size_t which = steady ? layout.placeIn(*steady) : 0;
    if (!steady && layout.barPlaces.size() > 1) {
        std::vector<std::int64_t> covered = coveredPixels(rows, layout.barPlaces, stripe.background);
        if (!tiles.gather) sumOfRanks(covered);
        which = freestPlace(covered);
    }
    drawFigure(rows, figure, layout, which);
    if (layout.barPlaces.empty()) return picture;
    const Box& legend = layout.barPlaces[which];
    picture.legend = {{legend.x, legend.y, legend.width, legend.height}};
    return picture;
}

}  // namespace aeolic
