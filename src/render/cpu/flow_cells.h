#pragma once

#include <cstdint>

#include "base/image.h"
#include "render/gbuffer.h"

namespace aeolic::cpu {

/// The four pixels of an interpolation cell side by side: (x, y), (x+1, y), (x, y+1), (x+1, y+1). One 128-bit load brings what a
/// bilinear sample of vector and noise needs; four gathers of the pixels themselves took 2.5 times as long (Zen 5).
struct alignas(16) FlowCell {
    std::uint32_t texel[4];  ///< flow_texel, but bit 0 (the noise's lowest) says: linked to all eight neighbours.
};

/// The G-buffer's flow as the tracer reads it. Memory is kept between frames.
struct FlowCells {
    Image<FlowCell> cells;  ///< One row more than the G-buffer above: cells between a pixel and its neighbours, border included.

    /// Local. Rearranges all of `buffer`. Cost: 16 bytes written per pixel.
    void build(const GBuffer& buffer);
};

}  // namespace aeolic::cpu
