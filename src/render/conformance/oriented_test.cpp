#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "data/load/loaded_scene.h"
#include "reference/reference.h"
#include "render/lic/lic_kernel.h"
#include "render_testing.h"
#include "test_paths.h"

/// Oriented streaks tell which way the flow goes (decision 0033).
namespace aeolic {
namespace {

using namespace testkit;

class Oriented : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Oriented, allBackends, backendName);

LicOptions orientedLic(LicMethod method = LicMethod::hierarchical)
{
    LicOptions lic;
    lic.method = method;
    lic.style = Style::oriented;
    return lic;
}

/// The values shown.
const Image<float>& shownValues(Stages& stages, const LicOptions& asked)
{
    const LicOptions lic = inShortSteps(asked, stages.view);
    const Extent whole = wholeImage(stages.view.camera);
    stages.backend->convolve(lic, whole);
    stages.backend->smooth(lic, whole);
    stages.backend->flatten(lic, whole);
    return stages.backend->probe().lic();
}

/// The share of windows of 25 x 25 pixels, all with flow, where the picture alone tells the direction: along a streak
/// values rise slowly and fall at its head, so slopes along the flow are skewed.
double shareTold(const GBuffer& buffer, const Image<float>& values)
{
    constexpr int side = 25;
    const Extent& all = buffer.valid();
    const auto at = [&](double x, double y) {
        const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
        const double wx = x - x0, wy = y - y0;
        return (1 - wy) * ((1 - wx) * double(values.at(x0, y0)) + wx * double(values.at(x0 + 1, y0))) +
               wy * ((1 - wx) * double(values.at(x0, y0 + 1)) + wx * double(values.at(x0 + 1, y0 + 1)));
    };
    int told = 0, windows = 0;
    for (int y0 = all.y0 + 2; y0 + side + 2 < all.y1; y0 += side)
        for (int x0 = all.x0 + 2; x0 + side + 2 < all.x1; x0 += side) {
            double skew = 0;
            bool whole = true;
            for (int y = y0 - 1; y <= y0 + side && whole; ++y)
                for (int x = x0 - 1; x <= x0 + side && whole; ++x) {
                    const std::uint32_t texel = buffer.flow.at(x, y);
                    const double dx = flow_texel::dx(texel), dy = flow_texel::dy(texel), length = std::hypot(dx, dy);
                    whole = texel != 0 && length > 0;
                    if (!whole || x < x0 || y < y0 || x == x0 + side || y == y0 + side) continue;
                    const double ux = dx / length, uy = dy / length;
                    const double slope = at(x + ux, y + uy) - at(x - ux, y - uy);
                    skew += slope * slope * slope;
                }
            windows += whole;
            told += whole && skew < 0;
        }
    return windows == 0 ? 0 : double(told) / windows;
}

Scene ahmed()
{
    SceneDescription description;
    description.surface.spec = AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed.vtp";
    description.field.vectors = "wallShearStress";
    return loadScene(description);
}

constexpr double kZooms[] = {0.9, 1.2, 1.6};  // The finer grains, both, the coarser.

double shareTold(Stages& stages, const LicOptions& lic, double zoom, int side)
{
    CameraOptions view;
    view.azimuth = 30;
    view.elevation = 20;
    view.zoom = zoom;
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, view, side, side), lic);
    return shareTold(buffer, shownValues(stages, lic));
}

TEST_P(Oriented, ThePictureAloneTellsTheDirection)
{
    const int side = GetParam() == "cpu" ? 800 : 400;
    const bool few = side < 800;  // Windows: what one of them says counts for more.
    for (const bool isTeapot : {true, false}) {
        Stages stages(GetParam(), isTeapot ? makeBuiltinScene("teapot", "abc") : ahmed());
        for (const double zoom : kZooms) {
            const double told = shareTold(stages, orientedLic(), zoom, side);
            std::printf("%s, zoom %.1f: %.3f\n", isTeapot ? "teapot" : "Ahmed body", zoom, told);
            EXPECT_GE(told, few ? 0.9 : 0.92) << isTeapot << ", " << zoom;
        }
        LicOptions dense;
        EXPECT_NEAR(shareTold(stages, dense, 1.2, side), 0.5, few ? 0.2 : 0.1);
    }
}

void expectAsQuarterSteps(const std::string& backend, const LicOptions& lic, double mostContrast)
{
    for (const char* surface : {"teapot:6000", "sphere:4000"}) {
        Stages stages(backend, makeBuiltinScene(surface, "abc:32,32,32"));
        CameraOptions close;
        close.zoom = 1.3;
        const Camera camera = fitCamera(stages.scene, close, 200, 150);
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
        const double contrast = standardDeviation(a) / standardDeviation(b);
        std::printf("%s: correlation %.3f, contrast %.3f\n", surface, correlation(a, b), contrast);
        EXPECT_GE(correlation(a, b), 0.97) << surface;
        EXPECT_GE(contrast, 0.95) << surface;
        EXPECT_LE(contrast, mostContrast) << surface;
    }
}

TEST_P(Oriented, IsWhatQuarterStepsMakeOfIt)
{
    expectAsQuarterSteps(GetParam(), orientedLic(), 1.06);
}

/// Comets are mixed from these.
TEST_P(Oriented, WavesAreWhatQuarterStepsMakeOfThem)
{
    for (const double phase : {0.0, 2.0}) {
        LicOptions lic = orientedLic();
        lic.flow = FlowMotion::loop;
        lic.phase = phase;
        expectAsQuarterSteps(GetParam(), lic, 1.06);
    }
}

/// One grain in a flow that is the same everywhere: its streak goes as far behind it as ahead, grows all the way, and
/// ends.
TEST(OrientedKernel, GrowsTowardsTheHead)
{
    LicOptions lic = orientedLic();
    lic.steps = 40;
    const KernelModel kernel = makeKernelModel(lic);
    EXPECT_EQ(kernel.weight(40), 0);  // Of a grain 40 steps downstream: the pixel is the streak's tail.
    EXPECT_EQ(kernel.weight(0), 0.5);
    EXPECT_EQ(kernel.weight(-40), 1);
    for (const float sign : {1.0F, -1.0F}) {
        const std::vector<Turn> turns = turnsOf(kernel, sign);
        ASSERT_EQ(turns.size(), 41U);
        // A sample after 13 steps, told by a jump that starts 8 steps on and finds it after 5.
        const Turn &before = turns[8], &within = turns[5], &all = turns[13];
        EXPECT_NEAR(double(before.ba * within.aa + before.bb * within.ba), double(all.ba), 1e-6);
        EXPECT_NEAR(double(before.aa * within.aa + before.ab * within.ba), double(all.aa), 1e-6);
        EXPECT_NEAR(0.5 * (1 + double(all.ba)), kernel.weight(sign > 0 ? 13 : -13), 1e-6);
    }
}

TEST(OrientedKernel, TakesASixthOfTheSteps)
{
    LicOptions lic;
    EXPECT_EQ(kernelSteps(lic), 128);
    lic.style = Style::oriented;
    EXPECT_EQ(kernelSteps(lic), 21);
    lic.steps = 1;
    EXPECT_EQ(kernelSteps(lic), 1);
}

/// No flow, a sink, one triangle over all the picture, flow that leaves the surface: values stay finite, and steady
/// places stay without streaks.
TEST_P(Oriented, TakesTheFlowsNobodyDraws)
{
    const auto expectFinite = [&](SurfaceMesh mesh, double distance) {
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        for (const LicMethod method : {LicMethod::hierarchical, LicMethod::direct}) {
            const LicOptions lic = orientedLic(method);
            stages.project(frontCamera(stages.scene, distance, 90, 60), lic);
            const Image<float>& shown = shownValues(stages, lic);
            for (int y = 0; y < 60; ++y)
                for (int x = 0; x < 90; ++x) EXPECT_LT(std::abs(shown.at(x, y)), 50) << x << "," << y;
        }
    };
    const auto plane = [](const VectorAt& vectorAt) {
        SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
        setPointVectors(mesh, vectorAt);
        return mesh;
    };
    expectFinite(plane([](const glm::dvec3&) { return glm::vec3(0); }), 4);
    expectFinite(plane([](const glm::dvec3&) { return glm::vec3(0, 0, 1); }), 4);
    expectFinite(plane([](const glm::dvec3& p) { return glm::vec3(-p); }), 4);
    expectFinite(plane([](const glm::dvec3&) { return glm::vec3(1, 0, 0); }), 0.01);
}

}  // namespace
}  // namespace aeolic
