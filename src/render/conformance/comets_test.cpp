#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "reference/reference.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/phase_mix.h"
#include "render_testing.h"

/// Oriented streaks that flow (decision 0034).
namespace aeolic {
namespace {

using namespace testkit;

class Comets : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Comets, allBackends, backendName);

LicOptions cometsLic(LicMethod method = LicMethod::hierarchical)
{
    LicOptions lic;
    lic.method = method;
    lic.style = Style::oriented;
    lic.flow = FlowMotion::loop;
    return lic;
}

/// Keeps what frames are mixed from.
void keepRuns(Stages& stages, const Camera& camera, const LicOptions& asked)
{
    const Extent whole = wholeImage(camera);
    stages.project(camera, asked);
    int kept = 0;
    for (const phase_mix::Run& run : phase_mix::runsOf(asked)) {
        if (run.grains != stages.view.noise.grains) {
            stages.view.noise.grains = run.grains;
            stages.backend->projectGrains(stages.view, whole, whole);
            stages.backend->complete(stages.view, whole);
        }
        LicOptions lic = inShortSteps(asked, stages.view);
        lic.phase = run.phase;
        stages.backend->convolve(lic, whole);
        stages.backend->smooth(lic, whole);
        stages.backend->keepPhase(kept++);
    }
    stages.backend->mixPhases(phase_mix::MeanOfComets{});
    stages.backend->flatten(asked, whole);
    stages.backend->keepPhase(phase_mix::kMeanOfComets);
}

std::vector<float> shownAt(Stages& stages, LicOptions lic, double phase)
{
    lic.phase = phase;
    stages.backend->mixPhases(phase_mix::mixtureOf(lic));
    const Image<float>& values = stages.backend->probe().lic();
    std::vector<float> all;
    for (int y = 0; y < values.valid().y1; ++y) all.insert(all.end(), values.row(y), values.row(y) + values.valid().x1);
    return all;
}

/// A plane that fills the picture, with vectors that lead to the right.
Stages planeWithWind(const std::string& backend)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    return Stages(backend, makeScene(std::move(mesh)));
}

constexpr int kWidth = 240, kHeight = 160;

/// The correlation of two pictures, the second of which is moved to the left by `shift` pixels.
double alike(const std::vector<float>& before, const std::vector<float>& after, int shift)
{
    std::vector<double> a, b;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 20; x < kWidth - 20; ++x) {
            a.push_back(double(before[std::size_t(y * kWidth + x)]));
            b.push_back(double(after[std::size_t(y * kWidth + x + shift)]));
        }
    return correlation(a, b);
}

TEST_P(Comets, RunDownstreamHeadFirst)
{
    for (const LicMethod method : {LicMethod::hierarchical, LicMethod::direct}) {
        Stages stages = planeWithWind(GetParam());
        const LicOptions lic = cometsLic(method);
        keepRuns(stages, frontCamera(stages.scene, 4, kWidth, kHeight), lic);
        const double wavelength = 2 * kernelSteps(lic) + 1;
        const int shift = 4;
        const std::vector<float> before = shownAt(stages, lic, 1),
                                 after = shownAt(stages, lic, 1 + 2 * std::numbers::pi * shift / wavelength);
        EXPECT_GT(alike(before, after, shift), 0.85);
        EXPECT_LT(alike(before, after, -shift), 0.65);
        // Values rise slowly along the flow and fall at the head.
        double skew = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 20; x < kWidth - 20; ++x) {
                const std::size_t at = std::size_t(y * kWidth + x);
                skew += std::pow(double(before[at + 1]) - double(before[at - 1]), 3);
            }
        EXPECT_LT(skew, 0);
    }
}

/// Were all grains of one phase, the whole picture would pulse.
TEST_P(Comets, PicturesOfACycleAreEquallyBright)
{
    Stages stages = planeWithWind(GetParam());
    const LicOptions lic = cometsLic();
    keepRuns(stages, frontCamera(stages.scene, 4, kWidth, kHeight), lic);
    std::vector<double> means, deviations;
    for (int i = 0; i < 8; ++i) {
        const std::vector<float> shown = shownAt(stages, lic, 2 * std::numbers::pi * i / 8);
        const std::vector<double> values(shown.begin(), shown.end());
        means.push_back(mean(values));
        deviations.push_back(standardDeviation(values));
    }
    const auto [least, most] = std::minmax_element(deviations.begin(), deviations.end());
    std::printf("deviation %.2f to %.2f, mean %.2f\n", *least, *most, mean(means));
    EXPECT_GT(*least, 0.85 * *most);
    EXPECT_NEAR(mean(deviations), 0.65, 0.15);  // As clear as oriented streaks that stand (contrast_test.cpp).
    for (const double m : means) EXPECT_NEAR(m, 0, 0.15);
}

/// The kernel of their runs.
TEST_P(Comets, WavesAreWhatQuarterStepsMakeOfThem)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:6000", "abc:32,32,32"));
    CameraOptions close;
    close.zoom = 1.3;
    const Camera camera = fitCamera(stages.scene, close, 200, 150);
    for (const double phase : {0.0, 2.0}) {
        LicOptions lic = cometsLic();
        lic.phase = phase;
        const GBuffer& buffer = stages.project(camera, lic);
        const std::vector<double> expected =
            reference::convolve(reference::fromGBuffer(buffer), inShortSteps(lic, stages.view), 4);
        const Image<float>& found = stages.convolve(lic);
        std::vector<double> a, b;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                if (buffer.flow.at(x, y) == 0) continue;
                a.push_back(double(found.at(x, y)));
                b.push_back(expected[std::size_t(y * camera.width + x)]);
            }
        std::printf("correlation %.3f, contrast %.3f\n", correlation(a, b),
                    standardDeviation(a) / standardDeviation(b));
        EXPECT_GE(correlation(a, b), 0.96);
        EXPECT_NEAR(standardDeviation(a) / standardDeviation(b), 1, 0.06);
    }
}

/// As in pictures that stand: a surface without flow is plain.
TEST_P(Comets, WhereThereIsNoFlowTheValueIsZero)
{
    SurfaceMesh mesh = makeRectangle({-4, 0, 0}, {4, 0, 0}, {0, 4, 0});
    append(mesh, makeRectangle({4, 0, 0}, {4, 0, 0}, {0, 4, 0}));
    setCellVectors(mesh, [](const glm::dvec3& p) { return p.x < 0 ? glm::vec3(std::nanf("")) : glm::vec3(0, 1, 0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    const LicOptions lic = cometsLic();
    keepRuns(stages, frontCamera(stages.scene, 4, kWidth, kHeight), lic);
    const std::vector<float> shown = shownAt(stages, lic, 1);
    const GBuffer& buffer = stages.backend->probe().gbuffer();
    int without = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (buffer.flow.at(x, y) != 0) continue;
            ++without;
            EXPECT_EQ(shown[std::size_t(y * kWidth + x)], 0) << x << ' ' << y;
        }
    EXPECT_GT(without, 1000);
    EXPECT_LT(without, kWidth * kHeight - 1000);
}

/// No flow, a flow through the surface, a sink, one triangle over all the picture.
TEST_P(Comets, StayFiniteWhereNobodyWouldDrawThem)
{
    const auto expectFinite = [&](const VectorAt& vectorAt, double distance) {
        SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
        setPointVectors(mesh, vectorAt);
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        const LicOptions lic = cometsLic();
        keepRuns(stages, frontCamera(stages.scene, distance, 90, 60), lic);
        for (const float value : shownAt(stages, lic, 1)) EXPECT_LT(std::abs(value), 50);
    };
    expectFinite([](const glm::dvec3&) { return glm::vec3(0); }, 4);
    expectFinite([](const glm::dvec3&) { return glm::vec3(0, 0, 1); }, 4);
    expectFinite([](const glm::dvec3& p) { return glm::vec3(-p); }, 4);
    expectFinite([](const glm::dvec3&) { return glm::vec3(1, 0, 0); }, 0.01);
}

}  // namespace
}  // namespace aeolic
