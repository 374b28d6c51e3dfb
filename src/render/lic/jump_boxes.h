#pragma once

#include <cstdint>
#include <vector>

#include "base/extent.h"

namespace aeolic {

/// Where jumps lead from a block of pixels: the least and the largest displacement, in JumpBoxes::unitPx, rounded
/// down. The real largest one is less than a unit more.
struct JumpBox {
    std::int8_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;
    bool empty() const { return x0 > x1; }  ///< No pixel of the block jumps.
    bool operator==(const JumpBox&) const = default;
};

/// The jump boxes of a stripe, for blocks of kColumns x kRows pixels from its first pixel on. The last ones may be
/// smaller.
struct JumpBoxes {
    static constexpr int kColumns = 16, kRows = 8;

    float unitPx = 1;            ///< 1/128 of the longest jump there could be.
    int columns = 0;             ///< How many blocks lie beside each other.
    std::vector<JumpBox> boxes;  ///< [rows of blocks][columns]

    static int columnsOf(int width) { return (width + kColumns - 1) / kColumns; }
    static int rowsOf(int height) { return (height + kRows - 1) / kRows; }
};

}  // namespace aeolic
