#pragma once

#include <cstdint>
#include <vector>

#include "base/extent.h"
#include "base/image.h"
#include "render/limits.h"

namespace aeolic {

/// From the first to the last flow texel (render/gbuffer.h) of `row` that is not 0, within columns [x0, x1).
ColumnSpan flowColumns(const std::uint32_t* row, int x0, int x1);

/// Where traces may read: around pixels with flow, as far as a step goes and a vector reaches (Image::kApron,
/// kApronRows). Nothing need be prepared, cleared or sent elsewhere, and most of a picture is background.
class NearFlow {
public:
    /// At most this much on each side of flow. Spans begin at multiples of half of these columns.
    static constexpr int kColumns = 2 * Image<std::uint32_t>::kApron, kRows = Image<std::uint32_t>::kApronRows;

    static_assert(kRows >= limits::kNearPx && kColumns / 2 >= limits::kNearPx);

    NearFlow() = default;

    /// For `rows`, from the columns of flow of each of them, [rows.height()]. Flow in other rows is left aside. Spans
    /// begin at multiples of kColumns / 2 from rows.x0 and are clipped to `rows`.
    NearFlow(const Extent& rows, const std::vector<ColumnSpan>& flow);

    const Extent& rows() const { return rows_; }
    const ColumnSpan& at(int y) const { return near_[std::size_t(y - rows_.y0)]; }

private:
    Extent rows_;
    std::vector<ColumnSpan> near_;
};

}  // namespace aeolic
