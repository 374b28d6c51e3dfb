#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/cpu/project/edge_pixels.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/view.h"

namespace aeolic::cpu {

/// What the surface shows at the samples of a tile's edge pixels, [pixels][kSamples] each. Memory is kept from tile to
/// tile.
struct EdgeSamples {
    /// A vector may begin with the last sample. The widest has 16 lanes, whichever machine compiles this.
    static constexpr std::size_t kPadding = 16;

    std::vector<std::uint64_t> keys;  ///< As TileKeys has them; 0: background.
    /// 1/depth (0: background), its change per pixel to the right and downwards on the sample's facet, and light.
    std::vector<float> invDepth, gradX, gradY, light;

    /// All background, for so many pixels.
    void clear(std::size_t pixels);
};

/// Local. Fills in what the keys show, by the arithmetic that pixels' centres have. Cost: 40 ns a pixel.
void resolveSamples(const EdgePixels& pixels, const SceneArrays& arrays, const View& view, EdgeSamples& samples);

}  // namespace aeolic::cpu
