#include "engine/tile_picture.h"

#include <array>
#include <optional>
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

/// Returns where the legends stand: x, y, width, height.
std::optional<std::array<int, 4>> addFigure(const PictureRows& rows, const Figure& figure, const Tile& tile,
                                            const LegendPlace& place)
{
    const FigureLayout layout(figure, rows.width, rows.height);
    std::size_t which = place.steady ? layout.placeIn(*place.steady) : 0;
    if (!place.steady && layout.barPlaces.size() > 1) {
        std::vector<std::int64_t> covered = coveredPixels(rows, layout.barPlaces, tile.background);
        place.sumOfRanks(covered);
        which = freestPlace(covered);
    }
    drawFigure(rows, figure, layout, which);
    if (layout.barPlaces.empty()) return std::nullopt;
    const Box& legend = layout.barPlaces[which];
    return {{legend.x, legend.y, legend.width, legend.height}};
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
                     Picture kept)
{
    DrawnFrame picture{gatheredPicture(tiles, height, std::move(kept)), 0, height, {}};
    LegendPlace place;
    place.steady = steady;
    picture.legend = addFigure(picture, figure, tiles.stripe, place);
    return picture;
}

DrawnFrame pictureOf(const Tile& stripe, int height, const Figure& figure, const LegendPlace& place, Picture kept)
{
    DrawnFrame picture{emptyPicture(stripe, stripe.extent.height(), std::move(kept)), stripe.extent.y0, height, {}};
    const PictureRows rows(picture, height, stripe.extent.y0);
    layOut(stripe, rows);
    picture.legend = addFigure(rows, figure, stripe, place);
    return picture;
}

}  // namespace aeolic
