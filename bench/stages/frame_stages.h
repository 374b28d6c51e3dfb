#pragma once

#include "engine/frame.h"

namespace aeolic {

/// How long the calls of a frame took, wall time.
struct StageTimes {
    double projectMs = 0, convolveMs = 0, shadeMs = 0;
};

/// Draws the picture of a process alone into `out`, which is as large: the stages of startFrame() one by one. On a GPU
/// the calls return before they are done; Backend::finish() waits for the picture.
StageTimes startStages(const FrameRequest& request, const Scene& scene, Backend& backend, Tile& out);

}  // namespace aeolic
