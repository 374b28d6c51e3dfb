#pragma once

#include <vector>

#include "render/cpu/edges/edge_colors.h"
#include "render/cpu/edges/edge_samples.h"
#include "render/cpu/project/visibility.h"
#include "render/edge_exchange.h"

namespace aeolic::cpu {

/// Local. What the triangles here show in the edge pixels of a tile. `visibility` has chosen triangles by edges.
void drawSamples(const Visibility& visibility, int tile, const EdgePixels& pixels, const EdgeScene& scene,
                 EdgeSamples& samples);

/// Local. What this rank's piece of the surface shows in the picture's edges `all`: those pixels in which it shows
/// anything, in the order of tiles.
std::vector<EdgePixelSeen> seenInEdges(const Visibility& visibility, const EdgeMask& all, const EdgeScene& scene);

}  // namespace aeolic::cpu
