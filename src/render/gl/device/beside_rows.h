#pragma once

#include "base/extent.h"
#include "render/gl/device/read_back.h"
#include "render/guard_exchange.h"

namespace aeolic::gl {

/// Words of four bytes, one for each pixel of a stripe and of rows beside it, in full width, as far as the picture
/// goes.
class BesideRows {
public:
    /// `compute`: the stripe's rows, global. `rows`: how many beside it, on each side. `height`: the picture's.
    void hold(const Extent& compute, int rows, int height);

    /// The rows that are held, global.
    const Extent& held() const { return held_; }
    /// Their words, for shaders to fill in those of the stripe, and to read.
    const Buffer& words() const { return words_.get(); }

    /// Collective. Brings the words of the rows beside the stripe from the ranks that own them.
    void receive(RowExchange& beside);

private:
    /// Bytes from the beginning to row `y`.
    std::size_t placeOf(int y) const;

    Extent compute_, held_;
    int rows_ = 0;
    GrowingBuffer words_{0};
    SharedMemory travelling_{true};
    Fence copied_;
};

}  // namespace aeolic::gl
