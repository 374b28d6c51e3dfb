#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/extent.h"
#include "base/uninitialized.h"
#include "render/tile.h"

namespace aeolic {

/// Colour channels of a picture: alpha is there where the background lets something through.
inline int channelsOn(const std::array<std::uint8_t, 4>& background)
{
    return background[3] == 255 ? 3 : 4;
}

/// The painted pixels of a tile on their way to another rank: row after row, nothing between them, and without alpha
/// where all are opaque.
struct PaintedPixels {
    Extent extent;
    std::array<std::uint8_t, 4> background{};
    std::vector<ColumnSpan> painted;  ///< [rows], within the extent's columns.
    Bytes bytes;

    int channels() const { return channelsOn(background); }
    std::size_t rowBytes(std::size_t row) const;  ///< How many bytes the row has, counted from the extent's first.
    std::size_t allBytes() const;                 ///< How many bytes `painted` asks for.
};

/// Packs the painted pixels of `tile`. Keeps `into`'s memory. Cost: a copy.
void pack(const Tile& tile, PaintedPixels& into);

/// Writes all pixels of these rows, background too, to their place in a picture that is as wide and has
/// channelsOn(background).
void layOut(const Tile& rows, const PictureRows& into);
void layOut(const PaintedPixels& rows, const PictureRows& into);

}  // namespace aeolic
