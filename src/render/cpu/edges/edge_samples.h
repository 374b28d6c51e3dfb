#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/cpu/project/visibility.h"
#include "render/edge_exchange.h"

namespace aeolic::cpu {

/// What the surface shows at the samples of a tile's edge pixels, [pixels][kSamples] each. Memory is kept from tile to
/// tile.
struct EdgeSamples {
    SampleKeys drawn;
    /// 1/depth (0: background), its change per pixel to the right and downwards on the sample's facet, and light.
    std::vector<float> invDepth, gradX, gradY, light;

    /// Gets the memory for so many pixels.
    void resize(std::size_t pixels);
};

/// Local. Fills in what the drawn samples show, by the arithmetic that pixels' centres have. Cost: 150 ns a pixel.
void resolveSamples(const SceneArrays& arrays, const View& view, EdgeSamples& samples);

/// Local. What the triangles here show in the edge pixels of a tile. `visibility` has chosen triangles by edges.
void drawSamples(const Visibility& visibility, int tile, const EdgePixels& pixels, const SceneArrays& arrays,
                 const View& view, EdgeSamples& samples);

/// Local. What this rank's piece of the surface shows in the picture's edges `all`: those pixels in which it shows
/// anything, in the order of tiles.
std::vector<EdgePixelSeen> seenInEdges(const Visibility& visibility, const EdgeMask& all, const SceneArrays& arrays,
                                       const View& view);

}  // namespace aeolic::cpu
