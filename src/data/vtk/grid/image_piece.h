#pragma once

#include <array>

#include "data/bricks.h"

namespace aeolic {

/// The part of an image file that is read, where that is not all.
struct ImagePiece {
    std::array<int, 6> wholeExtent{};  ///< Of the file: first and last sample in x, y, z.
    Brick brick;                       ///< Held. Counted from the first sample. May be empty.
    Brick own;                         ///< The same, or where a surface is cut out the cells that this rank cuts.

    GridIndex wholeDims() const
    {
        const auto& e = wholeExtent;
        return {std::int64_t(e[1]) - e[0] + 1, std::int64_t(e[3]) - e[2] + 1, std::int64_t(e[5]) - e[4] + 1};
    }
    /// Which of the samples between the first and the last in x, y and z, as the file counts, are this rank's.
    CountedSamples countedIn(const std::array<int, 6>& extent) const
    {
        CountedSamples counted{wholeDims(), {}, {}, own};
        for (std::size_t c = 0; c < 3; ++c) {
            counted.first[c] = extent[2 * c] - wholeExtent[2 * c];
            counted.held[c] = std::int64_t(extent[2 * c + 1]) - extent[2 * c] + 1;
        }
        return counted;
    }
    /// What to read: the brick's samples. Of an empty brick one cell, so that no file is too small to be read.
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
