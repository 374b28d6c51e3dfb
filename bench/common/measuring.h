#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Who follows a measurement while it goes on. Either may be empty.
template <class Measured>
struct Watch {
    /// Called before each piece of the measurement, with its name and how far the whole is, 0 to 1.
    std::function<void(const std::string& what, double fraction)> progress = {};
    /// Called whenever there is more to show: first with the facts of machine and scene and without a row, then
    /// after each row or group of rows. Rows shown once stay as they are.
    std::function<void(const Measured& soFar)> more = {};

    void tell(const std::string& what, double fraction) const
    {
        if (progress) progress(what, fraction);
    }
    void show(const Measured& soFar) const
    {
        if (more) more(soFar);
    }
};

/// With this zoom the built-in teapot covers some 70 % of a square picture.
inline constexpr double kTeapotZoom = 1.9;

/// Zooms in by the root of the sides' ratio, so that the surface covers as much of a wide picture as of a square one.
inline CameraOptions filling(CameraOptions camera, int width, int height)
{
    const auto [shorter, longer] = std::minmax(width, height);
    camera.zoom *= std::sqrt(double(longer) / shorter);
    return camera;
}

}  // namespace aeolic
