#pragma once

#include <span>
#include <vector>

#include "base/extent.h"
#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// The boxes of one direction in a whole image, as the ranks gave them.
class ImageBoxes {
public:
    /// `given`: of every rank, one after the other, those of its stripe in each of `directions`. Kept as a reference.
    ImageBoxes(const Stripes& stripes, const JumpBoxes& like, std::span<const JumpBox> given, int directions,
               int direction);

    /// Boxes that a rank gives for one direction.
    static std::size_t countOf(const Stripes& stripes, int rank, int columns);

    int columns() const { return columns_; }
    float unitPx() const { return unitPx_; }

    /// A row of blocks.
    struct Blocks {
        RowSpan rows;
        const JumpBox* boxes;  ///< [columns()]
    };
    const Blocks& at(int row) const { return blocks_[std::size_t(blocksOf_[std::size_t(row)])]; }

private:
    int columns_;
    float unitPx_;
    std::vector<Blocks> blocks_;
    std::vector<int> blocksOf_;  // [height]
};

/// The rows of each column of blocks that traces from a stripe get to by so many jumps, and what they read around
/// themselves there; at least the stripe, and none beyond `limits`, else in multiples of JumpFootprint::kRows. Traces
/// go where the nearest pixel's jump does, up to limits::kJumpMarginPx beside it. Cost: that of the blocks reached.
std::vector<RowSpan> footprintOf(const ImageBoxes& boxes, const RowSpan& stripe, const RowSpan& limits, int jumps);

/// Collective. What traces from each rank's stripe get to by so many jumps, for each direction of `boxes`, those of
/// this rank's stripe. `limits`: rows that this rank has room for. Cost:
/// two all-gathers, of every rank's boxes and of what each has found.
std::vector<JumpFootprint> shareFootprints(Communicator& communicator, const Stripes& stripes,
                                           const std::vector<JumpBoxes>& boxes, const RowSpan& limits, int jumps);

}  // namespace aeolic
