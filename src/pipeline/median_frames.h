#pragma once

#include <vector>

#include "aeolic/renderer.h"

namespace aeolic {

/// All ranks' parts of a frame, by rank.
using RanksOfFrame = std::vector<RankStats>;

/// One of frames that were drawn several times over, frames[repeat][frame]: for each rank and stage the middle one of
/// its busy times, everything else as in the last repeat. What the system did meanwhile slows a rank here and a rank
/// there, and the slowest of many ranks is then always one that was held up. At least one repeat, all of the same size.
std::vector<RanksOfFrame> medianFrames(const std::vector<std::vector<RanksOfFrame>>& frames);

}  // namespace aeolic
