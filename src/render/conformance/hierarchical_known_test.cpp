#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "render/lic/jump_plan.h"
#include "render_testing.h"

/// Composed jumps whose sums can be written down. A plane faces the camera, and steps of one pixel along a row or a
/// column meet pixel centres alone: nothing is interpolated, and jumps lose nothing however they are composed.
namespace aeolic {
namespace {

using namespace testkit;

class HierarchicalKnown : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, HierarchicalKnown, allBackends, backendName);

Scene uniformPlane(const glm::vec3& flow)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    setPointVectors(mesh, [&](const glm::dvec3&) { return flow; });
    return makeScene(std::move(mesh));
}

LicOptions hierarchicalLic(int steps, Kernel kernel, double phaseRad)
{
    LicOptions lic = directLic(steps, Integrator::rk2, kernel, phaseRad);
    lic.method = LicMethod::hierarchical;
    return lic;
}

double noiseOf(const GBuffer& buffer, int x, int y)
{
    return double(flow_texel::noise(buffer.flow.at(x, y)) - flow_texel::kNoiseZero);
}

/// What jumps sum up: noise that was sharpened against its four neighbours.
double sharpOf(const GBuffer& buffer, int x, int y)
{
    const double here = noiseOf(buffer, x, y), around = noiseOf(buffer, x - 1, y) + noiseOf(buffer, x + 1, y) +
                                                        noiseOf(buffer, x, y - 1) + noiseOf(buffer, x, y + 1);
    return here + double(kHierarchicalSharpness) * (4 * here - around);
}

/// Plans of one to three levels, with and without a remainder.
constexpr int kSteps[] = {5, 13, 17, 24, 40, 59, 72};

/// Every weight of the kernel, at both ends, too. The samples of level after level and of the remainder have their own.
TEST_P(HierarchicalKnown, UniformFlowFiltersTheNoise)
{
    for (const bool isAlongRows : {true, false}) {
        const int length = 200, across = 12, width = isAlongRows ? length : across,
                  height = isAlongRows ? across : length;
        Stages stages(GetParam(), uniformPlane(isAlongRows ? glm::vec3(1, 0, 0) : glm::vec3(0, -1, 0)));
        const Camera camera = frontCamera(stages.scene, 3, width, height, isAlongRows ? 4 : 10);
        for (const int steps : kSteps)
            for (const auto& [kernel, phase] : {std::pair(Kernel::box, 0.0), std::pair(Kernel::hann, 0.0),
                                                std::pair(Kernel::hann, 1.3), std::pair(Kernel::hann, -2.4)}) {
                const LicOptions lic = hierarchicalLic(steps, kernel, phase);
                const GBuffer& buffer = stages.project(camera, lic);
                const Image<float>& found = stages.convolve(lic);
                std::vector<double> filtered, values;
                for (int a = 2; a < across - 2; ++a)
                    for (int l = steps + 2; l < length - steps - 2; ++l) {
                        double sum = 0;
                        for (int i = -steps; i <= steps; ++i) {
                            const double hann = 0.5 * (1 + std::cos(std::numbers::pi * i / (steps + 0.5) - phase));
                            const int x = isAlongRows ? l + i : a, y = isAlongRows ? a : l + i;
                            const double noise = i == 0 ? noiseOf(buffer, x, y) : sharpOf(buffer, x, y);
                            sum += (kernel == Kernel::box ? 1.0 : hann) * noise;
                        }
                        filtered.push_back(sum);
                        values.push_back(double(isAlongRows ? found.at(l, a) : found.at(a, l)));
                    }
                const Fit fit = fitGain(filtered, values);
                RecordProperty("worst", std::to_string(fit.worst));
                EXPECT_GT(fit.gain, 0);
                EXPECT_LT(fit.worst, 0.12) << steps << " steps, phase " << phase << ", along rows " << isAlongRows;
            }
    }
}

/// A trace that ends at the surface's edge is averaged over what it walked, whichever jump it ends in.
TEST_P(HierarchicalKnown, TracesEndWithTheSurface)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {0.25, 0, 0}, {0, 2, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    for (const int steps : {24, 59, 100}) {
        const LicOptions lic = hierarchicalLic(steps, Kernel::box, 0);
        const GBuffer& buffer = stages.project(frontCamera(stages.scene, 4, 90, 40, 30), lic);
        const Image<float>& found = stages.convolve(lic);
        int first = 0, last = 89;
        while (buffer.flow.at(first, 20) == 0) ++first;
        while (buffer.flow.at(last, 20) == 0) --last;
        ASSERT_GE(last - first, 9);
        ASSERT_LE(last - first, 24);
        std::vector<double> differences;
        for (int y = 2; y < 38; ++y)  // All pixels of a row see the same whole row, but for their own noise.
            for (int x = first; x < last; ++x)
                differences.push_back(double(found.at(x, y)) - double(found.at(x + 1, y)));
        EXPECT_LT(standardDeviation(differences), 0.2) << steps;
    }
}

}  // namespace
}  // namespace aeolic
