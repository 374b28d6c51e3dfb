#pragma once

#include <cstdint>
#include <optional>

#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {

/// A triangle of any size made ready for its rows of pixels: at the first pixel centre of the current row, and per
/// pixel to the right.
struct TriangleRows {
    int x0, x1, y0, y1;    ///< Pixels of the tile to look at.
    std::int64_t edge[3];  ///< >= 0 inside; exact.
    std::int64_t edgeX[3], edgeY[3];
    double depth, depthX, depthY;  ///< 1/depth at corner a, and per sub-pixel.
    /// Sub-pixels from corner a. Depth is computed anew from there, so that no tile's edge shows.
    std::int64_t fromAX, fromAY;
    float lowest, highest, farthest, bias;  ///< `bias`: added once the depth is known (frontBias()).
    std::uint32_t notId;
    bool fitsDoubles;  ///< All edge values of its pixels are exact as doubles.

    double rowDepth() const { return depth + depthY * double(fromAY); }
    void nextRow()
    {
        for (int k = 0; k < 3; ++k) edge[k] += edgeY[k];
        fromAY += kSubpixels;
    }
};

/// Nothing where it has no area, is too far, or is nowhere over the tile. `margin`: so many sub-pixels beside a pixel's
/// centre a triangle counts as over it.
std::optional<TriangleRows> triangleRows(Corner a, Corner b, Corner c, std::uint32_t id, const Extent& tile, int margin,
                                         const DrawRule& rule);

}  // namespace aeolic::cpu
