#pragma once

#include <cstdint>

#include "render/cpu/edges/edge_samples.h"
#include "render/cpu/shade/shade.h"
#include "render/view.h"

namespace aeolic::cpu {

/// What edges are smoothed from.
struct EdgeScene : ShadeInput {
    const SceneArrays& arrays;
    const View& view;
};

/// Finished pixels of some rows before any edge was smoothed, with the rows next to them.
struct ShownRows {
    Extent rows;
    const Tile* inside = nullptr;                   ///< Holds these rows, and maybe others that are not finished.
    const Tile *above = nullptr, *below = nullptr;  ///< A row each, where the image has one.

    const std::uint8_t* pixel(int x, int y) const
    {
        const Tile& tile = y < rows.y0 ? *above : y >= rows.y1 ? *below : *inside;
        return tile.row(y) + 4 * std::ptrdiff_t(x - tile.extent.x0);
    }
};

/// Local. The smoothed colours of a tile's edge pixels, RGBA, [pixels.count()]: the mean of its samples' colours, which
/// begin with pixel `first` of `samples`.
///
/// A sample takes the colour of the pixel, of nine, whose sheet it lies on and whose facet fits it best, with its own
/// light. So streaks go on to the edge, and light and creases are the sample's own. What is seen at no pixel's centre
/// has no streaks: a lit surface with the scalar of the pixel that is nearest in depth. Cost: 150 ns a pixel.
void mixEdges(const EdgePixels& pixels, const EdgeSamples& samples, std::size_t first, const EdgeScene& scene,
              const ShownRows& shown, std::uint32_t* out);

}  // namespace aeolic::cpu
