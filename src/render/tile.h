#pragma once

#include <cstdint>
#include <vector>

#include "base/extent.h"

namespace aeolic {

/// Finished pixels of some rows: 8-bit RGBA, sRGB values, alpha not premultiplied, no padding.
struct Tile {
    Extent extent;
    std::vector<std::uint8_t> rgba;

    void resize(const Extent& rows)
    {
        extent = rows;
        rgba.resize(std::size_t(rows.width()) * std::size_t(rows.height()) * 4);
    }
    std::uint8_t* row(int y) { return rgba.data() + std::size_t(y - extent.y0) * std::size_t(extent.width()) * 4; }
    const std::uint8_t* row(int y) const
    {
        return rgba.data() + std::size_t(y - extent.y0) * std::size_t(extent.width()) * 4;
    }
};

}  // namespace aeolic
