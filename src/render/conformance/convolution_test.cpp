#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/reference.h"
#include "render_testing.h"

/// The LIC stage of every backend against streamlines in double precision on the same G-buffer.
namespace aeolic {
namespace {

using namespace testkit;

/// Single and double precision part where streamlines do, at saddles and where a trace just touches a silhouette:
/// nearly all pixels agree closely, and the few that do not are no reason for the picture to differ.
void expectAgreement(const GBuffer& buffer, const Image<float>& found, const std::vector<double>& expected,
                     double closeness)
{
    std::vector<double> a, b;
    std::size_t at = 0;
    for (int y = buffer.valid().y0; y < buffer.valid().y1; ++y)
        for (int x = buffer.valid().x0; x < buffer.valid().x1; ++x, ++at) {
            const double value = double(found.at(x, y));
            ASSERT_TRUE(std::isfinite(value)) << x << "," << y;
            if (buffer.flow.at(x, y) == 0) {
                ASSERT_EQ(value, 0) << x << "," << y;
                continue;
            }
            a.push_back(value);
            b.push_back(expected[at]);
        }
    ASSERT_GT(a.size(), 500u);
    const double unit = std::max(1.0, standardDeviation(b)), tolerance = 0.06 * unit;
    std::size_t close = 0;
    for (std::size_t i = 0; i < a.size(); ++i) close += std::abs(a[i] - b[i]) <= tolerance;
    EXPECT_GE(double(close), 0.95 * double(a.size()));
    EXPECT_NEAR(mean(a), mean(b), 0.01 * unit);
    EXPECT_GE(correlation(a, b), closeness);
}

std::string describe(const LicOptions& lic)
{
    return "integrator " + std::to_string(int(lic.integrator)) + ", steps " + std::to_string(lic.steps) +
           (lic.kernel == Kernel::hann ? ", hann, phase " + std::to_string(lic.phase) : "") +
           (lic.normalize ? "" : ", magnitudes");
}

void expectReference(Stages& stages, const Camera& camera, const LicOptions& lic)
{
    SCOPED_TRACE(describe(lic));
    const GBuffer& buffer = stages.project(camera, lic);
    const std::vector<double> expected =
        reference::convolve(reference::fromGBuffer(buffer), inShortSteps(lic, stages.view));
    forEachSimdTarget([&] { expectAgreement(buffer, stages.convolve(lic), expected, 0.999); });
}

class ConvolutionConformance : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, ConvolutionConformance, allBackends, backendName);

TEST_P(ConvolutionConformance, EveryIntegrator)
{
    Stages stages(GetParam(), makeBuiltinScene("torus:4000", "abc:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 120, 90);
    for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4})
        for (const int steps : {1, 7, 40}) expectReference(stages, camera, directLic(steps, integrator));
}

TEST_P(ConvolutionConformance, LongTraces)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:4000", "abc:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 120, 90);
    for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4})
        expectReference(stages, camera, directLic(128, integrator));
}

TEST_P(ConvolutionConformance, HannKernelAtAnyPhase)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:2000", "tornado:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 80, 60);
    for (const double phase : {0.0, 1.0, std::numbers::pi, -2.5, 20.0})
        for (const int steps : {1, 30})
            expectReference(stages, camera, directLic(steps, Integrator::rk2, Kernel::hann, phase));
}

TEST_P(ConvolutionConformance, StepsByMagnitude)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:2000", "abc:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 80, 60);
    LicOptions lic = directLic(40);
    lic.normalize = false;
    lic.step = 2;
    expectReference(stages, camera, lic);
}

/// A long step is asked for. The trace walks it in parts; even such a part hops over several links.
TEST_P(ConvolutionConformance, LongSteps)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:4000", "abc:32,32,32"));
    CameraOptions close;
    close.zoom = 2;
    const Camera camera = fitCamera(stages.scene, close, 120, 90);
    for (const double stepPx : {0.25, 3.5, 8.0}) {
        LicOptions lic = directLic(20);
        lic.step = stepPx;
        expectReference(stages, camera, lic);
    }
}

/// Flow from both sides into a line: a trace ends where it crosses that, and does not gather the noise there again and
/// again.
TEST_P(ConvolutionConformance, TracesEndWhereTheFlowTurnsBack)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 40);
    setCellVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(p.x + 0.3 * p.y < 0 ? 1 : -1, 0.15, 0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    for (const Integrator integrator : {Integrator::euler, Integrator::rk2})
        expectReference(stages, frontCamera(stages.scene, 4, 120, 90), directLic(40, integrator));
}

/// Creases and silhouettes everywhere: neighbours half of which are on another sheet.
TEST_P(ConvolutionConformance, PartialNeighbourhoods)
{
    SurfaceMesh mesh;
    for (int i = -4; i <= 4; ++i)
        append(mesh, makeRectangle({0.25 * i, 0.1 * (i % 3), -0.3 * std::abs(i)}, {0.11, 0.02, 0.02 * i},
                                   {-0.03, 1, 0.05 * i}, 2));
    setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(1 + p.y, 2 * p.x - 0.3, 0.2); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    CameraOptions above;
    above.azimuth = 5;
    above.elevation = 80;
    const Camera camera = fitCamera(stages.scene, above, 120, 90);
    for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4})
        expectReference(stages, camera, directLic(16, integrator));
}

/// A pixel sees the same instructions wherever it stands in a vector, so the vectors' width does not show: all targets
/// with fused multiply-adds give the same bits.
TEST_P(ConvolutionConformance, VectorWidthDoesNotShow)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:6000", "abc:32,32,32"));
    const Camera camera = fitCamera(stages.scene, {}, 150, 110);
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical})
        for (const Kernel kernel : {Kernel::box, Kernel::hann}) {
            LicOptions lic = directLic(60, Integrator::rk2, kernel);
            lic.method = method;
            std::vector<float> first;
            forEachSimdTarget([&] {
                if (stages.backend->simd() == "SSE4" || stages.backend->simd() == "SSSE3") return;
                stages.project(camera, lic);
                const Image<float>& found = stages.convolve(lic);
                std::vector<float> values;
                for (int y = 0; y < camera.height; ++y)
                    values.insert(values.end(), found.row(y), found.row(y) + camera.width);
                if (first.empty()) first = values;
                EXPECT_TRUE(values == first);
            });
        }
}

class ConvolutionConformanceLong : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, ConvolutionConformanceLong, allBackends, backendName);

TEST_P(ConvolutionConformanceLong, EverythingOnTheTeapot)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:6000", "tornado:64,64,64"));
    CameraOptions close;
    close.zoom = 1.6;
    const Camera camera = fitCamera(stages.scene, close, 320, 240);
    for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4})
        for (const Kernel kernel : {Kernel::box, Kernel::hann})
            for (const bool normalize : {true, false})
                for (const int steps : {1, 7, 128, 400}) {
                    LicOptions lic = directLic(steps, integrator, kernel, 0.7);
                    lic.normalize = normalize;
                    expectReference(stages, camera, lic);
                }
}

}  // namespace
}  // namespace aeolic
