#pragma once

#include <string>
#include <vector>

#include "data/scene.h"
#include "engine/started_frames.h"

namespace aeolic {

/// What the options of a frame ask for that these data, or a picture of this size, do not give: one line each. `times`:
/// the moments of the scene's steps.
std::vector<std::string> pictureWarnings(const StartedFrame& frame, const Scene& scene,
                                         const std::vector<double>& times, int width, int height);

}  // namespace aeolic
