#pragma once

#include <cstdint>

#include "render/cpu/transform.h"

namespace aeolic::cpu {

/// A triangle made ready for its rows of pixels: at the first pixel centre of the current row, and per pixel to the
/// right.
struct TriangleRows {
    int x0, x1, y0, y1;    // Pixels of the tile to look at.
    std::int64_t edge[3];  // >= 0 inside; exact.
    std::int64_t edgeX[3], edgeY[3];
    double depth, depthX, depthY;  // 1/depth at corner a, and per sub-pixel.
    std::int64_t fromAX,
        fromAY;  // Sub-pixels from corner a. Depth is computed anew from there, so that no tile's edge shows.

    double rowDepth() const { return depth + depthY * double(fromAY); }
    void nextRow()
    {
        for (int k = 0; k < 3; ++k) edge[k] += edgeY[k];
        fromAY += kSubpixels;
    }
    float lowest, highest, farthest;
    std::uint32_t notId;
};

}  // namespace aeolic::cpu
