#pragma once

#include <span>
#include <vector>

#include "aeolic/renderer.h"

namespace aeolic {

/// What drawing costs one rank of speed 1, from measurements. Nanoseconds per pixel, milliseconds per frame.
struct MeasuredCosts {
    double projectFixedMs = 0;   ///< Every rank, whatever its stripe: transforming and culling the whole surface.
    double projectPixelNs = 0;   ///< Each covered pixel, also of the guard where it is projected again.
    double projectAreaNs = 0;    ///< Any pixel of those rows, background too: clearing.
    double convolvePixelNs = 0;  ///< Each covered pixel of the stripe.
    double convolveGuardPixelNs =
        0;                      ///< Each covered pixel of the guard: there levels of the hierarchy are computed again.
    double convolveAreaNs = 0;  ///< Any pixel of the stripe and its guard: rearranging the flow.
    double shadePixelNs = 0;    ///< Any pixel of the stripe, background too.
    double packPixelNs = 0;     ///< Each covered pixel of the stripe, packed for rank 0. Rank 0 itself packs none.
    double coverageMs = 0;      ///< Every rank, where the balancer needs this frame's coverage.
};

/// What drawing costs, from frames that were drawn on various numbers of ranks: least squares of relative errors,
/// nothing below zero. `frames`: all ranks' parts, by rank, of pictures `imageWidth` wide. Leaves `coverageMs` at 0,
/// which frames do not tell.
MeasuredCosts fitCosts(std::span<const std::vector<RankStats>> frames, int imageWidth);

}  // namespace aeolic
