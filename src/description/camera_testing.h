#pragma once

#include <gtest/gtest.h>

#include "description/camera.h"

/// A scene to look at, and how its views are compared.
namespace aeolic::camera_testing {

inline const Bounds kBox{{-1, -2, 3}, {3, 2, 7}};  // Centre (1, 0, 5).
inline const glm::dvec3 kCenter(1, 0, 5);
inline constexpr double kRadius = 2.5;

inline CameraOptions absolute(const Vec3& position, const Vec3& focal)
{
    CameraOptions options;
    options.position = position;
    options.focal = focal;
    return options;
}

inline void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "component " << c;
}

}  // namespace aeolic::camera_testing
