#pragma once

#include <cstdint>

#include "base/image.h"
#include "render/jump_plan.h"

namespace aeolic::cpu {

/// Where the streamline of each pixel is after `stride` steps in one direction, and the noise summed on the way: the
/// hierarchy's φ_k and S_k (Hlawatsch, Sadlo & Weiskopf 2011). 64 bits a pixel, so that a 128-bit load brings two
/// neighbours:
///   bits  0 … 15  displacement in x, signed, in `displacementUnitPx`
///   bits 16 … 31  displacement in y
///   bits 32 … 47  sum of noise bytes times pixels, signed, in `sumUnit`
///   bit  48       the pixel and its neighbours are linked to all eight neighbours each
///   bit  49       the trace walked all its steps and may go on
///   bits 50 … 63  pixels walked, in `lengthUnitPx`
struct JumpLevel {
    Image<std::uint64_t> jumps;
    Image<std::uint32_t> waves;  ///< Hann only: sums weighted by cos and sin of the kernel's angle, 16 bits each.
    int stride = 0;
    float displacementUnitPx = 1, sumUnit = 1, lengthUnitPx = 1;
};

}  // namespace aeolic::cpu
