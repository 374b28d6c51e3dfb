#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "reference/reference.h"
#include "render_testing.h"

/// The hierarchical line integral against streamlines of quarter steps in double precision: it interpolates sums, so it
/// loses a little contrast across the flow and gains two orders of magnitude in speed.
namespace aeolic {
namespace {

using namespace testkit;

class Hierarchical : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Hierarchical, allBackends, backendName);

LicOptions hierarchicalLic(int steps, Kernel kernel = Kernel::box, double phaseRad = 0)
{
    LicOptions lic = directLic(steps, Integrator::rk4, kernel, phaseRad);
    lic.method = LicMethod::hierarchical;
    return lic;
}

struct Agreement {
    double correlation = 0, contrast = 0;
};

Agreement compare(Stages& stages, const Camera& camera, const LicOptions& lic)
{
    const GBuffer& buffer = stages.project(camera, lic);
    const std::vector<double> expected =
        reference::convolve(reference::fromGBuffer(buffer), inShortSteps(lic, stages.view), 4);
    const Image<float>& found = stages.convolve(lic);
    std::vector<double> a, b;
    std::size_t at = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x, ++at) {
            EXPECT_TRUE(std::isfinite(found.at(x, y)));
            if (buffer.flow.at(x, y) == 0) {
                EXPECT_EQ(found.at(x, y), 0) << x << "," << y;
                continue;
            }
            a.push_back(double(found.at(x, y)));
            b.push_back(expected[at]);
        }
    return {correlation(a, b), standardDeviation(a) / standardDeviation(b)};
}

TEST_P(Hierarchical, ResemblesTheStreamlines)
{
    for (const char* surface : {"sphere:4000", "torus:4000", "teapot:6000"})
        for (const int steps : {16, 128}) {
            Stages stages(GetParam(), makeBuiltinScene(surface, "abc:32,32,32"));
            CameraOptions close;
            close.zoom = 1.3;
            const Agreement found = compare(stages, fitCamera(stages.scene, close, 160, 120), hierarchicalLic(steps));
            EXPECT_GT(found.correlation, 0.93) << surface << ", " << steps << " steps";
            EXPECT_NEAR(found.contrast, 1, 0.12) << surface << ", " << steps << " steps";
        }
}

TEST_P(Hierarchical, AnyNumberOfStepsIsNotRoundedToAPowerOfTwo)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:4000", "rotation:16,16,16"));
    const Camera camera = fitCamera(stages.scene, {}, 120, 90);
    for (const int steps : {1, 2, 3, 5, 9, 31, 33, 100}) {
        const Agreement found = compare(stages, camera, hierarchicalLic(steps));
        EXPECT_GT(found.correlation, 0.92) << steps << " steps";
        EXPECT_NEAR(found.contrast, 1, 0.12) << steps << " steps";
    }
}

TEST_P(Hierarchical, HannKernelAtAnyPhase)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:4000", "abc:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 120, 90);
    for (const double phase : {0.0, 1.0, 3.14159, -2.5}) {
        const Agreement found = compare(stages, camera, hierarchicalLic(64, Kernel::hann, phase));
        EXPECT_GT(found.correlation, 0.9) << phase;
        EXPECT_NEAR(found.contrast, 1, 0.12) << phase;
    }
}

TEST_P(Hierarchical, EverySimdTarget)
{
    Stages stages(GetParam(), makeBuiltinScene("torus:4000", "abc:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 120, 90);
    forEachSimdTarget([&] { EXPECT_GT(compare(stages, camera, hierarchicalLic(60)).correlation, 0.9); });
}

/// Sums are interpolated among a sheet's own pixels only: what lies behind changes nothing in front, bit by bit.
TEST_P(Hierarchical, SilhouettesDoNotBleed)
{
    const auto plane = [](double z, double half, const glm::vec3& flow) {
        SurfaceMesh mesh = makeRectangle({0, 0, z}, {half, 0, 0}, {0, half, 0});
        setPointVectors(mesh, [&](const glm::dvec3&) { return flow; });
        return mesh;
    };
    const auto valuesWith = [&](const glm::vec3& front, const glm::vec3& back, bool wantFront) {
        SurfaceMesh mesh = plane(1, 0.5, front);
        append(mesh, plane(0, 2, back));
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        const LicOptions lic = hierarchicalLic(60);
        const GBuffer& buffer = stages.project(frontCamera(stages.scene, 5, 100, 80), lic);
        const Image<float>& found = stages.convolve(lic);
        std::vector<float> values;
        for (int y = 0; y < 80; ++y)
            for (int x = 0; x < 100; ++x) {
                const float invDepth = buffer.invDepth.at(x, y);
                if (invDepth > 0 && (invDepth * 4.5f > 1) == wantFront) values.push_back(found.at(x, y));
            }
        return values;
    };
    const glm::vec3 x(1, 0.2f, 0), y(-0.3f, 1, 0);
    EXPECT_EQ(valuesWith(x, x, true), valuesWith(x, y, true));
    EXPECT_EQ(valuesWith(x, x, false), valuesWith(y, x, false));
    EXPECT_NE(valuesWith(x, x, true), valuesWith(y, x, true));
}

}  // namespace
}  // namespace aeolic
