#pragma once

#include <cstdint>

#include "base/extent.h"

namespace aeolic::cpu {

/// Which triangle each pixel of one tile sees. Keys: bits of 1/depth above, complement of the triangle's id below, so
/// the larger key is nearer, ties go to the smaller id, and the order of drawing does not matter. 0: background.
struct TileKeys {
    static constexpr int kSize = 64;
    alignas(64) std::uint64_t key[kSize][kSize];
    std::uint64_t overhang[8];  ///< A vector that starts in the last row may reach past it.

    static std::uint32_t triangle(std::uint64_t k) { return ~std::uint32_t(k); }
};

/// A triangle's corner on the image: sub-pixels (transform.h), 1 / eye depth.
struct Corner {
    std::int64_t x, y;
    float invDepth;
};

/// Draws a triangle into the keys of `tile` (global pixels). Pixels whose centre lies inside or on an edge are drawn,
/// from either side; neighbours both draw a shared edge, and the keys' order settles who shows. Edge functions are
/// exact for any corner within the guard band. Nothing farther than 1 / farInvDepth is drawn.
void drawTriangle(Corner a, Corner b, Corner c, std::uint32_t id, const Extent& tile, float farInvDepth,
                  TileKeys& keys);

}  // namespace aeolic::cpu
