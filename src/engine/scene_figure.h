#pragma once

#include <string>
#include <vector>

#include "data/scene.h"
#include "engine/started_frames.h"
#include "render/overlay/figure.h"

namespace aeolic {

/// What the options of a started frame put around the surface. `times`: the moments of the scene's steps; empty where
/// nothing changes.
Figure figureOf(const StartedFrame& frame, const Scene& scene, const std::vector<double>& times);

/// "t = 0.250": with as many digits as tell apart a thousandth of what the times span, so that it keeps its width in an
/// animation.
std::string timeStampOf(double time, const std::vector<double>& times);

}  // namespace aeolic
