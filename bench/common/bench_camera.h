#pragma once

#include <algorithm>
#include <cmath>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Zooms in by the root of the sides' ratio, so that wide pictures are covered about like square ones.
inline CameraOptions filling(CameraOptions camera, int width, int height)
{
    const auto [shorter, longer] = std::minmax(width, height);
    camera.zoom *= std::sqrt(double(longer) / shorter);
    return camera;
}

}  // namespace aeolic
