#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "aeolic/plane.h"

namespace aeolic::testkit {

inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Plane {
    Plane(int w, int h, float ofU, float ofV) : width(w), height(h), u(pixels(), ofU), v(pixels(), ofV) {}
    std::size_t pixels() const { return std::size_t(width) * std::size_t(height); }
    PlaneFlow flow() const
    {
        return {width, height, u.data(), v.data(), texture.empty() ? nullptr : texture.data(), periodic, axial};
    }
    int width, height;
    std::vector<float> u, v, texture;
    bool periodic = false, axial = false;
};

inline LicOptions options(LicMethod method, int steps)
{
    LicOptions lic;
    lic.method = method;
    lic.steps = steps;
    return lic;
}

/// Eddies and saddles with an island among them; the texture's values are those that a noise byte holds.
inline Plane eddies(int width, int height, double size = 1)
{
    Plane plane(width, height, 0, 0);
    plane.texture.resize(plane.pixels());
    std::mt19937 random(1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = std::size_t(y * width + x);
            const double at = x / size, down = y / size;
            plane.u[i] = float(std::sin(0.11 * down) + 0.4 * std::cos(0.07 * at + 0.03 * down));
            plane.v[i] = float(std::cos(0.09 * at) - 0.3 * std::sin(0.05 * down));
            if (std::hypot(x - 40, y - 30) < 9) plane.u[i] = nan;
            plane.texture[i] = float(int(random() % 255) - 127) / 127;
        }
    plane.texture[0] = -1;
    plane.texture[1] = 1;
    return plane;
}

}  // namespace aeolic::testkit
