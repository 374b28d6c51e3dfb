#pragma once

#include <cstddef>
#include <vector>

#include "cluster/comm/communicator.h"
#include "render/backend.h"
#include "render/overlay/panel.h"

namespace aeolic {

/// Collective. Where the legend of an animation stays: the first of `places` that the surface, as the scene has it now,
/// covers least in the pictures of all `views` together. 0 where there is no place. The same on all ranks, however many
/// there are. Cost: nothing for less than two places, else the coverage of each view at about 160 rows. Where the
/// backend counts rows alone (a GPU), the processor draws for it, from a copy of the scene's triangles that is made
/// each time: the time and, meanwhile, the memory with which a processor's backend begins.
std::size_t steadyLegendPlace(const std::vector<Box>& places, const std::vector<View>& views, const Scene& scene,
                              Backend& backend, Communicator& ranks);

/// How much of a box such pixels cover, in pixels of the whole picture, which has `factor` times as many to a side.
std::int64_t coveredArea(const Box& box, const CoverageBits& bits, int factor);

/// Which frames of an animation stand for all of it: the first, and others at equal distances.
std::vector<int> sampledFrames(int frames);

}  // namespace aeolic
