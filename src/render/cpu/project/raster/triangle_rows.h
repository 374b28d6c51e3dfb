#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {

inline Corner cornerOf(const ScreenVertex& point)
{
    return {point.x, point.y, point.invDepth};
}

/// The pixels of `within` over whose centres' rows and columns a triangle is, or no farther than `margin` sub-pixels
/// beside them.
inline Extent pixelsOver(const Corner& a, const Corner& b, const Corner& c, int margin, const Extent& within)
{
    // A pixel centre lies at 256 x + 128: the first at or after the least corner, to the last at or before the
    // greatest.
    const auto first = [&](std::int64_t v) { return int((v - margin + kSubpixels / 2 - 1) >> kSubpixelBits); };
    const auto pastLast = [&](std::int64_t v) { return int(((v + margin - kSubpixels / 2) >> kSubpixelBits) + 1); };
    return {std::max(first(std::min({a.x, b.x, c.x})), within.x0),
            std::max(first(std::min({a.y, b.y, c.y})), within.y0),
            std::min(pastLast(std::max({a.x, b.x, c.x})), within.x1),
            std::min(pastLast(std::max({a.y, b.y, c.y})), within.y1)};
}

/// A triangle of any size made ready for its rows of pixels: at the first pixel centre of the current row, and per
/// pixel to the right.
struct TriangleRows {
    Extent over;           ///< Pixels of the tile to look at.
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
