#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "render_testing.h"

/// Line integrals whose result can be written down.
namespace aeolic {
namespace {

using namespace testkit;

class KnownFlows : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, KnownFlows, allBackends, backendName);

Scene planeWith(const VectorAt& vectorAt, int cells = 1)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, cells);
    setPointVectors(mesh, vectorAt);
    return makeScene(std::move(mesh));
}

double noiseOf(const GBuffer& buffer, int x, int y)
{
    return double(flow_texel::noise(buffer.flow.at(x, y)) - flow_texel::kNoiseZero);
}

/// On a plane that faces the camera a step of one pixel along x meets pixel centres alone: the line integral is the
/// row's noise, filtered by the kernel, times a gain that all interior pixels share.
TEST_P(KnownFlows, UniformFlowFiltersTheRowsNoise)
{
    constexpr int width = 96, height = 24, steps = 16;
    Stages stages(GetParam(), planeWith([](const glm::dvec3&) { return glm::vec3(1, 0, 0); }));
    const Camera camera = frontCamera(stages.scene, 3, width, height, 10);
    for (const Kernel kernel : {Kernel::box, Kernel::hann})
        for (const double phase : {0.0, 2.0})
            for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4}) {
                const LicOptions lic = directLic(steps, integrator, kernel, phase);
                const GBuffer& buffer = stages.project(camera, lic);
                const Image<float>& found = stages.convolve(lic);
                std::vector<double> filtered, values;
                for (int y = 0; y < height; ++y)
                    for (int x = steps; x < width - steps; ++x) {
                        double sum = 0;
                        for (int i = -steps; i <= steps; ++i) {
                            const double hann = 0.5 * (1 + std::cos(std::numbers::pi * i / (steps + 0.5) - phase));
                            sum += (kernel == Kernel::box ? 1.0 : hann) * noiseOf(buffer, x + i, y);
                        }
                        filtered.push_back(sum);
                        values.push_back(double(found.at(x, y)));
                    }
                const Fit fit = fitGain(filtered, values);
                EXPECT_GT(fit.gain, 0);
                EXPECT_LT(fit.worst, 0.12) << "phase " << phase;
            }
}

/// A quarter of a turn more of phase moves the kernel by a quarter of its length, 2 steps + 1 pixels.
TEST_P(KnownFlows, HannPhaseMovesTheKernelDownstream)
{
    constexpr int width = 160, height = 40, steps = 20, shift = 10;
    Stages stages(GetParam(), planeWith([](const glm::dvec3&) { return glm::vec3(1, 0, 0); }));
    const Camera camera = frontCamera(stages.scene, 3, width, height, 10);
    const auto valuesAt = [&](double phase, int offset) {
        const LicOptions lic = directLic(steps, Integrator::rk2, Kernel::hann, phase);
        stages.project(camera, lic);
        const Image<float>& found = stages.convolve(lic);
        std::vector<double> values;
        for (int y = 0; y < height; ++y)
            for (int x = steps + shift; x < width - steps - shift; ++x)
                values.push_back(double(found.at(x + offset, y)));
        return values;
    };
    const double quarter = std::numbers::pi / 2;
    EXPECT_GT(correlation(valuesAt(quarter, 0), valuesAt(0, shift)), 0.85);
    EXPECT_LT(correlation(valuesAt(quarter, 0), valuesAt(0, -shift)), 0.5);
}

TEST_P(KnownFlows, APhaseOfAFullTurnChangesNothing)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:800", "rotation:8,8,8"));
    const Camera camera = fitCamera(stages.scene, {}, 60, 50);
    std::vector<double> once, again;
    for (auto [phase, values] : {std::pair(0.4, &once), std::pair(0.4 + 2 * std::numbers::pi, &again)}) {
        const LicOptions lic = directLic(12, Integrator::rk2, Kernel::hann, phase);
        const GBuffer& buffer = stages.project(camera, lic);
        const Image<float>& found = stages.convolve(lic);
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 60; ++x)
                if (buffer.flow.at(x, y) != 0) values->push_back(double(found.at(x, y)));
    }
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(once[i], again[i], 1e-4);
}

/// Values a few pixels apart along a circle about the centre are nearly the same, across it they have nothing to do
/// with each other.
TEST_P(KnownFlows, RotationDrawsCircles)
{
    constexpr int size = 160, steps = 48;
    constexpr double apart = 4;
    Stages stages(GetParam(), planeWith([](const glm::dvec3& p) { return glm::vec3(-p.y, p.x, 0); }));
    const LicOptions lic = directLic(steps);
    stages.project(frontCamera(stages.scene, 3, size, size, 30), lic);
    const Image<float>& found = stages.convolve(lic);
    const auto bilinear = [&](double x, double y) {
        const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
        const double wx = x - x0, wy = y - y0;
        return (1 - wy) * ((1 - wx) * double(found.at(x0, y0)) + wx * double(found.at(x0 + 1, y0))) +
               wy * ((1 - wx) * double(found.at(x0, y0 + 1)) + wx * double(found.at(x0 + 1, y0 + 1)));
    };
    const double center = 0.5 * size - 0.5;
    const auto at = [&](double radius, double angle) {
        return bilinear(center + radius * std::cos(angle), center - radius * std::sin(angle));
    };
    std::vector<double> here, along, across;
    for (double radius = 15; radius < 70; radius += 2)
        for (double angle = 0; angle < 2 * std::numbers::pi; angle += 5 / radius) {
            here.push_back(at(radius, angle));
            along.push_back(at(radius, angle + apart / radius));
            across.push_back(at(radius + apart, angle));
        }
    EXPECT_GT(correlation(here, along), 0.9);
    EXPECT_LT(std::abs(correlation(here, across)), 0.2);
}

/// Upstream and downstream are summed alike: the flow's sign shows only in where an uneven kernel lies.
TEST_P(KnownFlows, ReversedFlowLooksTheSame)
{
    const auto values = [&](float sign) {
        Stages stages(GetParam(),
                      planeWith([sign](const glm::dvec3& p) { return sign * glm::vec3(1, 0.4 + 0.3 * p.x, 0); }, 8));
        const LicOptions lic = directLic(20);
        stages.project(frontCamera(stages.scene, 3, 80, 60, 30), lic);
        const Image<float>& found = stages.convolve(lic);
        std::vector<double> all;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x) all.push_back(double(found.at(x, y)));
        return all;
    };
    EXPECT_GT(correlation(values(1), values(-1)), 0.9999);
}

/// A trace that ends at the surface's edge is averaged over what it walked.
TEST_P(KnownFlows, TracesEndWithTheSurface)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {0.1, 0, 0}, {0, 2, 0});  // A strip a few pixels wide.
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    const LicOptions lic = directLic(64, Integrator::euler);
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 4, 60, 50, 30), lic);
    const Image<float>& found = stages.convolve(lic);
    int first = 0, last = 59;
    while (buffer.flow.at(first, 25) == 0) ++first;
    while (buffer.flow.at(last, 25) == 0) --last;
    ASSERT_GE(last - first, 3);
    for (int y = 1; y < 49; ++y)  // All pixels of a row see the same whole row.
        for (int x = first; x < last; ++x)
            EXPECT_NEAR(double(found.at(x, y)), double(found.at(x + 1, y)), 0.06) << x << "," << y;
}

}  // namespace
}  // namespace aeolic
