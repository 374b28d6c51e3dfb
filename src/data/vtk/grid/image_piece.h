#pragma once

#include <array>

#include "data/bricks.h"

namespace aeolic {

/// The part of an image file that is read.
struct ImagePiece {
    std::array<int, 6> wholeExtent{};  ///< The file's first and last sample in x, y, z.
    Brick brick;                       ///< What is held, counted from the first sample. May be empty.
    Brick own;  ///< The rank's own cells: where a surface is cut out of them, fewer than it holds.

    GridIndex wholeDims() const
    {
        const auto& e = wholeExtent;
        return {std::int64_t(e[1]) - e[0] + 1, std::int64_t(e[3]) - e[2] + 1, std::int64_t(e[5]) - e[4] + 1};
    }
    /// Which samples this rank counts, of those between the first and the last in x, y and z (as the file numbers
    /// them).
    CountedSamples countedIn(const std::array<int, 6>& extent) const
    {
        CountedSamples counted{wholeDims(), {}, {}, own};
        for (std::size_t c = 0; c < 3; ++c) {
            counted.first[c] = extent[2 * c] - wholeExtent[2 * c];
            counted.held[c] = std::int64_t(extent[2 * c + 1]) - extent[2 * c] + 1;
        }
        return counted;
    }
    /// What to read: the brick's samples. For an empty brick it is one cell: every file has that.
    std::array<int, 6> extent() const
    {
        std::array<int, 6> samples{};
        for (std::size_t c = 0; c < 3; ++c) {
            samples[2 * c] = wholeExtent[2 * c] + (brick.empty() ? 0 : int(brick.cellLo[c]));
            samples[2 * c + 1] = wholeExtent[2 * c] + (brick.empty() ? 1 : int(brick.cellHi[c]));
        }
        return samples;
    }
};

}  // namespace aeolic
