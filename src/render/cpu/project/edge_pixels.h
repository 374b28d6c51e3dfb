#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/antialias.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"
#include "render/edge_mask.h"

namespace aeolic::cpu {

/// Sub-pixels in the unit of antialias.h.
inline constexpr int kSubpixelsPerPart = kSubpixels / antialias::kParts;
/// Samples lie up to so many sub-pixels beside a pixel's centre.
inline constexpr int kSampleMargin = antialias::kReach * kSubpixelsPerPart;

/// The edge pixels of a tile. They are counted strip after strip, each of some columns, and row after row within a
/// strip. So those in the rows of a small triangle follow each other, and a vector of them can be looked at at once.
/// Pixel i has the samples from kSamples * i on. Memory is kept from tile to tile.
class EdgePixels {
public:
    static constexpr int kColumns = 16, kStrips = TileKeys::kSize / kColumns;
    /// A vector may begin with the last pixel. The widest has 16 lanes.
    static constexpr std::size_t kPadding = 16;

    /// Local. Those of `mask` in a tile.
    void find(const EdgeMask& mask, const Extent& tile)
    {
        static_assert(TileKeys::kSize == 64 && kStrips * kColumns == 64, "a row of a tile is a word");
        tile_ = tile;
        const auto row = [&](int k) {
            return tile.y0 + k < tile.y1 ? mask.row(tile.y0 + k)[tile.x0 / TileKeys::kSize] : 0;
        };
        for (int k = 0; k < kRows; ++k) above_[std::size_t(k) + 1] = above_[std::size_t(k)] + perStrip(row(k));
        for (int s = 0; s < kStrips; ++s) first_[std::size_t(s) + 1] = first_[std::size_t(s)] + inStrip(s, kRows);
        x_.resize(count() + kPadding);
        y_.resize(count() + kPadding);
        right_.resize(count() + kPadding);
        down_.resize(count() + kPadding);
        std::array<std::uint32_t, kStrips> next{};
        std::copy_n(first_.begin(), kStrips, next.begin());
        for (int k = 0; k < kRows; ++k)
            for (std::uint64_t left = row(k); left != 0; left &= left - 1) {
                const int column = std::countr_zero(left);
                const std::size_t at = next[std::size_t(column / kColumns)]++;
                x_[at] = tile.x0 + column;
                y_[at] = tile.y0 + k;
                right_[at] = float(column);
                down_[at] = float(k);
            }
    }

    const Extent& tile() const { return tile_; }
    std::uint32_t count() const { return first_.back(); }
    /// Global pixels, [count()], and then anything for a vector.
    const std::int32_t* x() const { return x_.data(); }
    const std::int32_t* y() const { return y_.data(); }
    /// Columns and rows of these pixels, counted from the tile's first pixel.
    const float* right() const { return right_.data(); }
    const float* down() const { return down_.data(); }

    /// The strip of a column of the tile.
    int strip(int x) const { return (x - tile_.x0) / kColumns; }
    /// Those in rows [y0, y1) of the tile and one of its strips follow each other.
    struct Range {
        std::uint32_t begin, end;
    };
    Range range(int strip, int y0, int y1) const
    {
        return {before(strip, y0 - tile_.y0), before(strip, y1 - tile_.y0)};
    }
    /// The number of a pixel of the tile, where it is one of the edge's.
    std::optional<std::uint32_t> at(int x, int y) const
    {
        const Range beside = range(strip(x), y, y + 1);
        const auto last = x_.begin() + beside.end, found = std::find(x_.begin() + beside.begin, last, x);
        if (found != last) return std::uint32_t(found - x_.begin());
        return std::nullopt;
    }

private:
    static constexpr int kRows = TileKeys::kSize;

    /// How many bits are set in each 16 of a word, 16 bits each.
    static std::uint64_t perStrip(std::uint64_t word)
    {
        word -= (word >> 1) & 0x5555'5555'5555'5555u;
        word = (word & 0x3333'3333'3333'3333u) + ((word >> 2) & 0x3333'3333'3333'3333u);
        word = (word + (word >> 4)) & 0x0F0F'0F0F'0F0F'0F0Fu;
        return (word + (word >> 8)) & 0x00FF'00FF'00FF'00FFu;
    }
    /// How many lie in the first rows of a strip.
    std::uint32_t inStrip(int strip, int rows) const
    {
        return std::uint32_t(above_[std::size_t(rows)] >> (kColumns * strip)) & 0xFFFFu;
    }
    /// The number of the first pixel in a row of a strip or later.
    std::uint32_t before(int strip, int row) const { return first_[std::size_t(strip)] + inStrip(strip, row); }

    Extent tile_;
    std::array<std::uint64_t, kRows + 1> above_{};  // Pixels of each strip in the rows above, 16 bits each.
    std::array<std::uint32_t, kStrips + 1> first_{};
    std::vector<std::int32_t> x_, y_;
    std::vector<float> right_, down_;
};

}  // namespace aeolic::cpu
