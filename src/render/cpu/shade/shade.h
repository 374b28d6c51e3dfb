#pragma once

#include "base/image.h"
#include "render/gbuffer.h"
#include "render/palette.h"
#include "render/tile.h"

namespace aeolic::cpu {

/// What the blending stage reads.
struct ShadeInput {
    const GBuffer& buffer;
    const Image<float>& lic;
    const Image<float>& open;  ///< As OcclusionStage leaves it; read where the palette has occlusion.
    const Palette& palette;
};

/// Local. The blending stage (paper, section 3; formulas: shading_model.h) over the rows of `compute`: base colour,
/// light and LIC on the surface, the background elsewhere. Every pixel depends on its own inputs alone: no image
/// statistics, so no split of the image can show. Cost: about 2 ns per pixel and core.
void shadeRows(const ShadeInput& input, const Extent& compute, Tile& out);

}  // namespace aeolic::cpu
