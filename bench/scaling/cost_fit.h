#pragma once

#include <span>
#include <vector>

#include "aeolic/renderer.h"
#include "scaling/simulator.h"

namespace aeolic {

/// What drawing costs, from frames as they were drawn on various numbers of ranks: least squares of relative errors,
/// nothing below zero. `frames`: all ranks' parts, by rank, of pictures `imageWidth` wide. Coverage is
/// for others to measure.
MeasuredCosts fitCosts(std::span<const std::vector<RankStats>> frames, int imageWidth);

}  // namespace aeolic
