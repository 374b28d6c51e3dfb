#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "render/antialias.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"
#include "render/edge_mask.h"

namespace aeolic::cpu {

/// Sub-pixels in the unit of antialias.h.
inline constexpr int kSubpixelsPerPart = kSubpixels / antialias::kParts;
/// Samples lie up to so many sub-pixels beside a pixel's centre.
inline constexpr int kSampleMargin = antialias::kReach * kSubpixelsPerPart;

/// The edge pixels of a tile, counted row after row. Pixel i has the samples from kSamples * i on.
struct EdgePixels {
    Extent tile;
    std::array<std::uint64_t, TileKeys::kSize> bits{};        ///< Of row tile.y0 + k: columns from tile.x0 on.
    std::array<std::uint32_t, TileKeys::kSize + 1> before{};  ///< How many lie in the rows above.

    EdgePixels(const EdgeMask& mask, const Extent& extent) : tile(extent)
    {
        static_assert(TileKeys::kSize == 64, "a row of a tile is a word");
        for (int k = 0; k < TileKeys::kSize; ++k) {
            const bool has = tile.y0 + k < tile.y1;
            bits[std::size_t(k)] = has ? mask.row(tile.y0 + k)[tile.x0 / TileKeys::kSize] : 0;
            before[std::size_t(k) + 1] = before[std::size_t(k)] + std::uint32_t(std::popcount(bits[std::size_t(k)]));
        }
    }
    std::uint32_t count() const { return before.back(); }

    /// Those in columns [x0, x1) of row y, of the tile, a bit each.
    std::uint64_t some(int x0, int x1, int y) const
    {
        return bits[std::size_t(y - tile.y0)] & columns(x0 - tile.x0, x1 - tile.x0);
    }
    struct Pixel {
        std::uint32_t number;
        int x;
    };
    /// The first of some() in row y.
    Pixel first(std::uint64_t some, int y) const
    {
        const int bit = std::countr_zero(some);
        const std::uint64_t earlier = bits[std::size_t(y - tile.y0)] & ~(~std::uint64_t{0} << bit);
        return {before[std::size_t(y - tile.y0)] + std::uint32_t(std::popcount(earlier)), tile.x0 + bit};
    }
    /// Calls visit(number, x, y) for all.
    template <class Visit>
    void forEach(const Visit& visit) const
    {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (std::uint64_t left = bits[std::size_t(y - tile.y0)]; left != 0; left &= left - 1) {
                const Pixel pixel = first(left, y);
                visit(pixel.number, pixel.x, y);
            }
    }

    /// Bits [x0, x1) of a word, 0 <= x0 < x1 <= 64.
    static std::uint64_t columns(int x0, int x1)
    {
        return (~std::uint64_t{0} << x0) & (~std::uint64_t{0} >> (64 - x1));
    }
};

}  // namespace aeolic::cpu
