#pragma once

#include <cstdint>

#include "base/extent.h"
#include "render/front_bias.h"

namespace aeolic::cpu {

/// Which triangle each pixel of one tile sees. Keys: bits of 1/depth (with frontBias()) above, complement of the
/// triangle's id below, so the larger key is nearer, ties go to the smaller id, and the order of drawing does not
/// matter. 0: background.
struct TileKeys {
    static constexpr int kSize = 64;
    alignas(64) std::uint64_t key[kSize][kSize];
    std::uint64_t overhang[8];  ///< A vector that starts in the last row may reach past it.

    static std::uint32_t triangle(std::uint64_t k) { return ~std::uint32_t(k); }
};

/// For blocks of a tile, what all their pixels show something nearer than: a triangle beyond cannot be seen there.
struct TileDepths {
    static constexpr int kBlock = 8, kBlocks = TileKeys::kSize / kBlock;
    float farthest[kBlocks][kBlocks];  ///< 1/depth; 0 where some pixel shows nothing.

    /// Whether a 1/depth is beyond all that columns [x0, x1) and rows [y0, y1) of the tile show.
    bool hide(float invDepth, int x0, int y0, int x1, int y1) const
    {
        for (int y = y0 / kBlock; y <= (y1 - 1) / kBlock; ++y)
            for (int x = x0 / kBlock; x <= (x1 - 1) / kBlock; ++x)
                if (invDepth >= farthest[y][x]) return false;
        return true;
    }
};

/// What a tile shows so far.
TileDepths farthestDepths(const TileKeys& keys);

/// A triangle's corner on the image: sub-pixels (transform.h), 1 / eye depth.
struct Corner {
    std::int64_t x, y;
    float invDepth;
};

/// How triangles are drawn.
struct DrawRule {
    float farInvDepth = 0;   ///< Nothing farther than 1 / farInvDepth is drawn.
    bool frontOnly = false;  ///< Nor triangles turned away from the viewer.
};

/// Draws a triangle into the keys of `tile` (global pixels). Pixels whose centre lies inside or on an edge are drawn,
/// from either side; neighbours both draw a shared edge, and the keys' order decides which shows. Edge functions are
/// exact for any corner within the guard band. `drawn`, if any: what the tile showed before, so that hidden triangles
/// need not be looked at pixel by pixel.
///
/// Where faces are in the same place, the one turned to the viewer shows: its corners run counterclockwise, as seen by
/// the viewer. Where both are, or neither, and their corners are the same, the smaller id shows.
void drawTriangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, const Extent& tile,
                  const DrawRule& rule, const TileDepths* drawn, TileKeys& keys);

}  // namespace aeolic::cpu
