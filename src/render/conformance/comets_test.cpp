#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

#include "cluster/comm/communicator.h"
#include "description/choices.h"
#include "engine/frame.h"
#include "render/lic/lic_kernel.h"
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

/// Draws frames of a cycle, and tells the values that they show.
class Cycle {
public:
    Cycle(const std::string& backend, SurfaceMesh mesh, double distance, int width, int height)
        : scene_(makeScene(std::move(mesh))),
          backend_(makeBackend(*choiceNamed<BackendChoice>(backend), scene_)),
          camera_(frontCamera(scene_, distance, width, height))
    {
    }
    Backend& backend() { return *backend_; }

    /// Row after row.
    std::vector<float> at(double phase, LicMethod method = LicMethod::hierarchical)
    {
        FrameRequest request{camera_, cometsLic(method), {}};
        request.lic.phase = phase;
        request.inCycle = true;
        renderFrame(request, scene_, *backend_, group_, frame_);
        const Image<float>& values = backend_->probe().lic();
        std::vector<float> all;
        for (int y = 0; y < values.valid().y1; ++y)
            all.insert(all.end(), values.row(y), values.row(y) + values.valid().x1);
        return all;
    }

private:
    Scene scene_;
    std::unique_ptr<Backend> backend_;
    Camera camera_;
    FrameGroup group_{makeSerialCommunicator(), {}};
    Frame frame_;
};

/// A plane that fills the picture, with vectors that lead to the right.
SurfaceMesh planeWithWind()
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    return mesh;
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
        Cycle cycle(GetParam(), planeWithWind(), 4, kWidth, kHeight);
        const double wavelength = 2 * kernelSteps(cometsLic(method)) + 1;
        const int shift = 4;
        const std::vector<float> before = cycle.at(1, method),
                                 after = cycle.at(1 + 2 * std::numbers::pi * shift / wavelength, method);
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
    Cycle cycle(GetParam(), planeWithWind(), 4, kWidth, kHeight);
    std::vector<double> means, deviations;
    for (int i = 0; i < 8; ++i) {
        const std::vector<float> shown = cycle.at(2 * std::numbers::pi * i / 8);
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

/// Where a surface has no flow it is plain, as it is without comets.
TEST_P(Comets, WhereThereIsNoFlowTheValueIsZero)
{
    SurfaceMesh mesh = makeRectangle({-4, 0, 0}, {4, 0, 0}, {0, 4, 0});
    append(mesh, makeRectangle({4, 0, 0}, {4, 0, 0}, {0, 4, 0}));
    setCellVectors(mesh, [](const glm::dvec3& p) { return p.x < 0 ? glm::vec3(std::nanf("")) : glm::vec3(0, 1, 0); });
    Cycle cycle(GetParam(), std::move(mesh), 4, kWidth, kHeight);
    const std::vector<float> shown = cycle.at(1);
    const GBuffer& buffer = cycle.backend().probe().gbuffer();
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
        Cycle cycle(GetParam(), std::move(mesh), distance, 90, 60);
        for (const float value : cycle.at(1)) EXPECT_LT(std::abs(value), 50);
    };
    expectFinite([](const glm::dvec3&) { return glm::vec3(0); }, 4);
    expectFinite([](const glm::dvec3&) { return glm::vec3(0, 0, 1); }, 4);
    expectFinite([](const glm::dvec3& p) { return glm::vec3(-p); }, 4);
    expectFinite([](const glm::dvec3&) { return glm::vec3(1, 0, 0); }, 0.01);
}

}  // namespace
}  // namespace aeolic
