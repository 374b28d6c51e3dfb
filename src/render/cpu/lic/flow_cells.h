#pragma once

#include <cstdint>

#include "base/image.h"
#include "render/gbuffer.h"
#include "render/lic/fresh_rows.h"
#include "render/lic/near_flow.h"

namespace aeolic::cpu {

/// The four pixels of an interpolation cell side by side: (x, y), (x+1, y), (x, y+1), (x+1, y+1). One 128-bit load
/// brings what a bilinear sample of vector and noise needs; four gathers of the pixels themselves took 2.5 times as
/// long (Zen 5).
///
/// A texel is like the G-buffer's, but read without unpacking: as a signed 32-bit number it is the displacement in x
/// times 2^20, shifted left by 12 that in y, and the low byte is the noise. Each field is rounded so that it comes out
/// right with the bits below it. Bit 0 of texel[0] is a flag and no part of the noise, which is even there: the four
/// pixels are open (limits::kOpenRings). Whoever comes from limits::kOpenReachPx around is on their sheet.
struct alignas(16) FlowCell {
    std::uint32_t texel[4];
};
inline constexpr float kFlowCellUnit = 1.0f / (1 << 20);

/// The G-buffer's flow as the tracer reads it. Memory is kept between frames.
struct FlowCells {
    static constexpr int kYShift = 12;

    Image<FlowCell> cells;  ///< At the place of their upper left pixel, the apron's first row and column included.
    float noiseUnit = 1;    ///< Noise bytes of the G-buffer per noise byte here.

    /// Local. Rearranges the rows of `near` near flow, reading a row further; the memory spans all that is valid. With
    /// `sharpness` s the noise is N + s * sum(N - N_k) over the linked neighbours E, W, N and S: what later
    /// interpolation of sums of this noise takes off its fine contrast is put on beforehand. Cost: 20 bytes written per
    /// pixel. Cells that follow from rows before the fresh ones alone stay, as far as level 0 of jumps, whose traces
    /// walk `steps` steps, is to be computed anew. So do those of the window before in the apron above: no trace reads
    /// them.
    void build(const GBuffer& buffer, const NearFlow& near, float sharpness, const FreshRows& fresh = {},
               int steps = 0);

private:
    Image<std::uint32_t> texels_;
};

}  // namespace aeolic::cpu
