#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/extent.h"
#include "base/image.h"
#include "render/lic/jump_boxes.h"
#include "render/lic/near_flow.h"

namespace aeolic {

/// Any image's rows as bytes. Valid until the image is resized.
struct ImageRows {
    std::byte* firstPixel = nullptr;  ///< (valid.x0, valid.y0)
    std::ptrdiff_t strideBytes = 0;
    int pixelBytes = 0;
    Extent valid;

    std::byte* at(int x, int y) const
    {
        return firstPixel + (y - valid.y0) * strideBytes + std::ptrdiff_t(x - valid.x0) * pixelBytes;
    }
};

template <class T>
ImageRows imageRows(Image<T>& image)
{
    return {reinterpret_cast<std::byte*>(image.origin()), image.stride() * std::ptrdiff_t(sizeof(T)), int(sizeof(T)),
            image.valid()};
}

/// Which rows every rank's traces read, column by column of JumpBoxes::kColumns pixels.
struct JumpFootprint {
    static constexpr int kRows = 8;  ///< Spans begin and end at multiples of that, or where the guard rows do.
    int columns = 0;
    std::vector<RowSpan> rows;  ///< [ranks][columns]; with the rank's own.
};

/// Images whose rows come with one message from each owner, and how far traces read them.
struct GuardPart {
    std::vector<ImageRows> images;
    int reach = 0;                           ///< Integration steps.
    const JumpFootprint* reached = nullptr;  ///< If given, only these of the rows come.
    std::optional<int> had = {};             ///< If given, the rows that traces of so many steps read are there.
};

/// Brings the rows that other ranks own to where a stripe's traces read them.
class GuardExchange {
public:
    virtual ~GuardExchange() = default;

    /// Local. The rows around this rank's stripe that traces of so many steps may read.
    virtual GuardRows rows(int steps) const = 0;

    /// Local. The rows at the upper and at the lower end of this rank's stripe that traces of others, of so many
    /// steps, may read.
    virtual GuardRows sentRows(int steps) const = 0;

    /// Local. Where the projection found flow in a row that another rank owns.
    virtual ColumnSpan flowOf(int row) const = 0;

    /// Collective. Where traces from each rank's stripe get to by so many jumps of one level, of each direction apart.
    /// `boxes`: of this rank's stripe, one for each direction. `steps`: what bounds it. Nothing where guards go by the
    /// bound alone. Cost: 4 bytes to all for each block of pixels, 8 for each column of blocks.
    virtual std::vector<JumpFootprint> reached(const std::vector<JumpBoxes>& boxes, int steps, int jumps) = 0;

    /// Collective. Fills those rows of every part's images, each right in its owner's stripe, from their owners. The
    /// same parts with the same reach and pixel sizes on every rank. Pixels without flow become zeros near those with
    /// flow (NearFlow) and keep their values elsewhere. Where only reached pixels come, they become what the
    /// owner has there.
    virtual void receive(const std::vector<GuardPart>& parts) = 0;
};

/// Brings the rows beside a stripe that other ranks have finished.
class RowExchange {
public:
    virtual ~RowExchange() = default;

    /// Collective. Fills `rows` rows above and as many below this rank's stripe, in full width, from their owners, as
    /// far as the picture goes. `image` holds them and the stripe, which is right. Cost: a message to each neighbour.
    virtual void receive(const ImageRows& image, int rows) = 0;
};

}  // namespace aeolic
