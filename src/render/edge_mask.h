#pragma once

#include "base/extent.h"
#include "render/coverage_bits.h"

namespace aeolic {

/// Which pixels of some rows lie at an edge: a silhouette, a crease, a line where two surfaces cross.
struct EdgeMask {
    Extent rows;        ///< Global pixels, all columns of the image.
    CoverageBits bits;  ///< Row 0 is rows.y0.

    void clear(const Extent& all)
    {
        rows = all;
        bits.clear(all.width(), all.height());
    }
    std::uint64_t* row(int y) { return &bits.words[std::size_t(y - rows.y0) * bits.wordsPerRow]; }
    const std::uint64_t* row(int y) const { return &bits.words[std::size_t(y - rows.y0) * bits.wordsPerRow]; }
};

}  // namespace aeolic
