#pragma once

#include <cstdint>

#include "render/cpu/lic/flow_cells.h"

namespace aeolic::cpu {

/// A plane's flow in more bits than a G-buffer keeps, for callers that want the numbers and not a picture.
struct FineFlow {
    static constexpr int kPerUnit = 16;           ///< So many units of a displacement are one of the G-buffer's.
    static constexpr int kNoisePerByte = 1 << 8;  ///< So many of the noise are one of its bytes.
    static constexpr int kNoiseZero = 1 << 15;    ///< The noise that means 0.

    /// Displacements per step. A word as a signed number is the one in x times 2^16. The word shifted left by 16 bits
    /// is the one in y times 2^16.
    Image<std::uint32_t> vectors;
    Image<std::uint16_t> noise;
    bool axial = false;  ///< A vector and its negative are the same: PlaneFlow::axial.

    /// Rows that were there stay.
    void roll(const Extent& valid)
    {
        vectors.roll(valid, valid.y0);
        noise.roll(valid, valid.y0);
    }
};

/// FineFlow as the tracer reads it: two loads bring what a bilinear sample needs.
struct FineCells {
    static constexpr int kYShift = 16;

    Image<FlowCell> cells;        ///< Of vectors. Bit 0 of texel[0] is the flag that the pixels are open.
    Image<std::uint64_t> noises;  ///< Of the same four pixels, 16 bits each, the first lowest.
    const FineFlow* flow = nullptr;

    /// Local. Rearranges all of `from`, which must stay as long as this is read. Cost: 24 bytes written per pixel.
    void build(const GBuffer& buffer, const FineFlow& from);
};

}  // namespace aeolic::cpu
