#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "data/load/loaded_scene.h"
#include "reference/reference.h"
#include "render_testing.h"
#include "test_paths.h"

/// How close the methods come to streamlines in double precision, RK4 with quarter steps: the numbers
/// docs/hierarchical.md quotes, of the values that are shown. `scripts/test --all` prints the table.
namespace aeolic {
namespace {

using namespace testkit;

struct Case {
    const char* name;
    const char* surface;
    const char* flow;  // Null: the wall shear stress of the Ahmed body.
    double azimuthDeg, elevationDeg, zoom;
};

Scene makeCaseScene(const Case& c)
{
    if (c.flow) return makeBuiltinScene(c.surface, c.flow);
    SceneDescription description;
    description.surface.spec = AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed.vtp";
    description.field.vectors = "wallShearStress";
    return loadScene(description);
}

struct Agreement {
    double correlation, contrast;
};

Agreement agreement(const GBuffer& buffer, const Image<float>& found, const std::vector<double>& expected)
{
    std::vector<double> a, b;
    const int width = buffer.valid().width();
    for (int y = 0; y < buffer.valid().height(); ++y)
        for (int x = 0; x < width; ++x) {
            if (buffer.flow.at(x, y) == 0) continue;
            a.push_back(double(found.at(x, y)));
            b.push_back(expected[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
        }
    return {correlation(a, b), standardDeviation(a) / standardDeviation(b)};
}

class LicAccuracyLong : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Scenes, LicAccuracyLong,
                         testing::Values(Case{"ahmedRear", "", nullptr, 50, 30, 1.3},
                                         Case{"ahmedFront", "", nullptr, -60, 15, 1.3},
                                         Case{"teapotAbc", "teapot", "abc", 30, 20, 1.5},
                                         Case{"teapotTornado", "teapot", "tornado", 30, 20, 1.5},
                                         Case{"sphereAbc", "sphere", "abc", 30, 20, 1},
                                         Case{"sphereTornado", "sphere", "tornado", 30, 20, 1},
                                         Case{"planeAbc", "plane", "abc", 0, 60, 1.2},
                                         Case{"planeTornado", "plane", "tornado", 0, 90, 1.2}),
                         [](const testing::TestParamInfo<Case>& test) { return std::string(test.param.name); });

TEST_P(LicAccuracyLong, AgainstQuarterSteps)
{
    const Case& c = GetParam();
    Stages stages("cpu", makeCaseScene(c));
    CameraOptions view;
    view.azimuth = c.azimuthDeg;
    view.elevation = c.elevationDeg;
    view.zoom = c.zoom;
    LicOptions lic = directLic(128, Integrator::rk4);
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, view, 400, 400), lic);
    const reference::PixelImage image = reference::fromGBuffer(buffer);
    const LicOptions walked = inShortSteps(lic, stages.view);
    const std::vector<double> expected = reference::smooth(image, reference::convolve(image, walked, 4), walked);

    const auto measure = [&](LicMethod method, Integrator integrator) {
        lic.method = method;
        lic.integrator = integrator;
        stages.convolve(lic);
        stages.backend->smooth(inShortSteps(lic, stages.view), wholeImage(stages.view.camera));
        return agreement(buffer, stages.backend->probe().lic(), expected);
    };
    const Agreement euler = measure(LicMethod::direct, Integrator::euler),
                    rk2 = measure(LicMethod::direct, Integrator::rk2);
    const Agreement hierarchical = measure(LicMethod::hierarchical, Integrator::rk2);
    std::printf("%-14s  Euler %.3f / %.3f   RK2 %.3f / %.3f   hierarchical %.3f / %.3f\n", c.name, euler.correlation,
                euler.contrast, rk2.correlation, rk2.contrast, hierarchical.correlation, hierarchical.contrast);
    EXPECT_GE(rk2.correlation, 0.96);
    EXPECT_NEAR(rk2.contrast, 1, 0.03);
    EXPECT_GE(hierarchical.correlation, 0.95);
    EXPECT_NEAR(hierarchical.contrast, 1, 0.08);
}

}  // namespace
}  // namespace aeolic
