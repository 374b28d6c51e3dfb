#pragma once

/// What the render core's tests share: small scenes with known answers, a backend run stage by stage, statistics.

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "data/scene.h"
#include "render/backend.h"
#include "render/lic/noise.h"
#include "render/view.h"

namespace aeolic::testkit {

using VectorAt = std::function<glm::vec3(const glm::dvec3& positionWorld)>;

/// A flat rectangle of 2 * cells^2 triangles; its normal is halfU x halfV.
SurfaceMesh makeRectangle(const glm::dvec3& centerWorld, const glm::dvec3& halfU, const glm::dvec3& halfV,
                          int cells = 1);

/// Twelve triangles with sharp edges, along the axes.
SurfaceMesh makeCube(const glm::dvec3& centerWorld, double halfSide);

/// Adds `other` behind what is there, with its vectors; both share originWorld 0.
void append(SurfaceMesh& mesh, const SurfaceMesh& other);

void setPointVectors(SurfaceMesh& mesh, const VectorAt& vectorAt);
void setCellVectors(SurfaceMesh& mesh, const VectorAt& vectorAtCentroid);

/// `vectorAt` sampled on dims samples whose first and last lie on `bounds`.
std::shared_ptr<const GridField> makeField(const Bounds& bounds, const std::array<std::int64_t, 3>& dims,
                                           const VectorAt& vectorAt);

/// A scene from parts, with bounds and largest vector filled in.
Scene makeScene(SurfaceMesh mesh, std::shared_ptr<const GridField> field = nullptr);

/// A built-in surface under a built-in flow.
Scene makeBuiltinScene(const std::string& surface, const std::string& flow);

/// The view `options` ask for, with the scene's own bounding sphere.
Camera fitCamera(const Scene& scene, const CameraOptions& options, int width, int height);

/// Looks along -z at the origin with x to the right and y up, so that the plane z = 0 faces the camera and a step of
/// 1 pixel is one pixel long.
Camera frontCamera(const Scene& scene, double distance, int width, int height, double fovDeg = 30);

/// The point of the surface that pixel (x, y) shows.
glm::dvec3 positionAt(const Camera& camera, double invDepth, int x, int y);

/// Where a point falls in the image: pixel coordinates (integers are pixel centres) and eye depth.
glm::dvec3 imageOf(const Camera& camera, const glm::dvec3& positionWorld);

inline Extent wholeImage(const Camera& camera)
{
    return {0, 0, camera.width, camera.height};
}

/// The direct method with a kernel of `steps`: what the reference computes.
LicOptions directLic(int steps, Integrator integrator = Integrator::rk2, Kernel kernel = Kernel::box,
                     double phaseRad = 0);

/// One scene on one backend, stage by stage over whole images.
struct Stages {
    Scene scene;
    NoisePyramid noise;
    std::unique_ptr<Backend> backend;
    View view;                        ///< What the last project() drew with.
    const GBuffer* buffer = nullptr;  ///< What the last project() left.

    Stages(const std::string& backendName, Scene theScene, std::uint32_t seed = 1);
    Stages(const Stages&) = delete;
    Stages& operator=(const Stages&) = delete;

    const GBuffer& project(const Camera& camera, const LicOptions& lic);
    const Image<float>& convolve(const LicOptions& lic);
    const Image<float>& convolve(const LicOptions& lic, const Extent& compute);
};

/// Why `backend` cannot be had here; empty where it can. Of `gl` any device will do, also one that is a program; what
/// its driver has to say is an error in every test.
std::string whyNoBackend(const std::string& backend);

/// For SetUp(): skips the test where `backend` cannot be had, with its own words why. Where AEOLIC_REQUIRE_GL is set,
/// as in scripts/test, which installs a renderer, the test fails instead.
void skipWithout(const std::string& backend);

/// Suites that every backend has to pass: INSTANTIATE_TEST_SUITE_P(Backends, Suite, allBackends, backendName).
class BackendTest : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override { skipWithout(GetParam()); }
};
inline const auto allBackends = ::testing::Values("cpu", "gl");
inline std::string backendName(const ::testing::TestParamInfo<std::string>& info)
{
    return info.param;
}

/// Calls `body` once for every SIMD target that this build and this machine have.
void forEachSimdTarget(const std::function<void()>& body);

double mean(const std::vector<double>& values);
double standardDeviation(const std::vector<double>& values);
double correlation(const std::vector<double>& a, const std::vector<double>& b);

/// The factor that brings gain * a closest to b, and how far off the worst value then is.
struct Fit {
    double gain = 0, worst = 0;
};
Fit fitGain(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace aeolic::testkit
