#include "render/lic/along_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "reference/reference.h"
#include "render/lic/lic_kernel.h"
#include "render_testing.h"

/// The second, short convolution along the flow: on every backend, and against the reference.
namespace aeolic {
namespace {

using namespace testkit;

class AlongFlow : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, AlongFlow, allBackends, backendName);

std::vector<double> valuesOf(const Image<float>& image)
{
    const Extent& extent = image.valid();
    std::vector<double> values;
    for (int y = extent.y0; y < extent.y1; ++y)
        for (int x = extent.x0; x < extent.x1; ++x) values.push_back(double(image.at(x, y)));
    return values;
}

/// A whirl around the middle, sheets that hide each other, flow that ends.
TEST_P(AlongFlow, IsWhatTheReferenceMakesOfTheSameValues)
{
    for (const char* surface : {"teapot:3000", "torus:3000"})
        for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
            Stages stages(GetParam(), makeBuiltinScene(surface, "tornado:24,24,24"));
            LicOptions lic = directLic(24);
            lic.method = method;
            const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 133, 90), lic);
            const std::vector<double> before = valuesOf(stages.convolve(lic));
            const std::vector<double> expected = reference::smooth(reference::fromGBuffer(buffer), before, lic);
            stages.backend->smooth(lic, wholeImage(stages.view.camera));
            const std::vector<double> found = valuesOf(stages.backend->probe().lic());
            double farthest = 0, changed = 0;
            for (std::size_t i = 0; i < found.size(); ++i) {
                farthest = std::max(farthest, std::abs(found[i] - expected[i]));
                changed += std::abs(found[i] - before[i]) > 0.01;
            }
            EXPECT_LT(farthest, 1e-3) << surface;
            EXPECT_GT(changed, 1000) << surface;
        }
}

/// One value at one pixel: where it is found again are the taps, and by how much are the weights.
TEST_P(AlongFlow, TapsLieOnTheLineAlongThePixelsVector)
{
    const struct {
        glm::vec3 flow;
        int x[7], y[7];
    } lines[] = {{{1, 0, 0}, {-3, -2, -1, 0, 1, 2, 3}, {0, 0, 0, 0, 0, 0, 0}},
                 {{0, 1, 0}, {0, 0, 0, 0, 0, 0, 0}, {-3, -2, -1, 0, 1, 2, 3}},
                 {{1, -1, 0}, {-3, -2, -1, 0, 1, 2, 3}, {-3, -2, -1, 0, 1, 2, 3}},
                 {{1, 0.4f, 0}, {-3, -2, -1, 0, 1, 2, 3}, {1, 1, 0, 0, 0, -1, -1}},
                 {{-0.2f, 1, 0}, {-1, 0, 0, 0, 0, 0, 1}, {-3, -2, -1, 0, 1, 2, 3}}};
    const float weights[7] = {0.4f, 0.75f, 1, 1, 1, 0.75f, 0.4f};
    for (const auto& line : lines) {
        SurfaceMesh plane = makeRectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
        setPointVectors(plane, [&](const glm::dvec3&) { return line.flow; });
        Stages stages(GetParam(), makeScene(std::move(plane)));
        const LicOptions lic = directLic(20);
        stages.project(frontCamera(stages.scene, 3, 41, 41), lic);
        Image<float> values;
        values.resize(stages.convolve(lic).valid());
        for (int y = 0; y < 41; ++y) std::fill_n(&values.at(0, y), 41, 0.0f);
        values.at(20, 20) = 1;
        stages.backend->probe().setLic(values);
        stages.backend->smooth(lic, wholeImage(stages.view.camera));
        const Image<float>& found = stages.backend->probe().lic();
        float total = 0, all = 0;
        for (const float weight : weights) all += weight;
        for (int k = 0; k < 7; ++k)
            EXPECT_NEAR(found.at(20 + line.x[k], 20 + line.y[k]) / along_flow::gain(lic), weights[k] / all, 1e-4)
                << "tap " << k - 3 << " of the flow " << line.flow.x << " " << line.flow.y;
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 41; ++x) total += found.at(x, y);
        EXPECT_NEAR(total, along_flow::gain(lic), 1e-3) << "nothing else has a share";
    }
}

/// Two plates, one before the other, share an edge in the image alone: values stay on their side of it.
TEST_P(AlongFlow, StopsAtSilhouettes)
{
    SurfaceMesh plates = makeRectangle({-2, 0, 0}, {2, 0, 0}, {0, 3, 0});
    append(plates, makeRectangle({2, 0, -1.5}, {4, 0, 0}, {0, 5, 0}));
    setPointVectors(plates, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    Stages stages(GetParam(), makeScene(std::move(plates)));
    const LicOptions lic = directLic(20);
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 4, 60, 40), lic);
    const auto isNear = [&](int x, int y) { return 1 / buffer.invDepth.at(x, y) < 4.5; };
    Image<float> values;
    values.resize(stages.convolve(lic).valid());
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) values.at(x, y) = buffer.flow.at(x, y) == 0 ? 0.0f : isNear(x, y) ? 2.0f : -2.0f;
    stages.backend->probe().setLic(values);
    stages.backend->smooth(lic, wholeImage(stages.view.camera));
    const Image<float>& found = stages.backend->probe().lic();
    int nearPixels = 0, farPixels = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) {
            if (buffer.flow.at(x, y) == 0) continue;
            (isNear(x, y) ? nearPixels : farPixels)++;
            EXPECT_NEAR(found.at(x, y), isNear(x, y) ? 2.0 : -2.0, 0.2) << x << ", " << y;
        }
    EXPECT_GT(nearPixels, 100);
    EXPECT_GT(farPixels, 100);
}

/// Plain streaks are the paper's. Without streaks nothing is convolved.
TEST_P(AlongFlow, LeavesPlainStreaksAlone)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:3000", "abc:16,16,16"));
    LicOptions lic = directLic(24);
    lic.streaks = Streaks::plain;
    stages.project(fitCamera(stages.scene, {}, 90, 70), lic);
    const std::vector<double> before = valuesOf(stages.convolve(lic));
    stages.backend->smooth(lic, wholeImage(stages.view.camera));
    EXPECT_EQ(valuesOf(stages.backend->probe().lic()), before);
}

/// The contrast of uniform flow stays what it was, whatever the kernel and however short it is.
TEST(AlongFlowGain, BringsTheContrastBack)
{
    for (const Kernel kernel : {Kernel::box, Kernel::hann})
        for (const int steps : {4, 16, 100}) {
            SurfaceMesh plane = makeRectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
            setPointVectors(plane, [](const glm::dvec3&) { return glm::vec3(0.9, 0.3, 0); });
            Stages stages("cpu", makeScene(std::move(plane)));
            const LicOptions lic = directLic(steps, Integrator::rk2, kernel);
            stages.project(frontCamera(stages.scene, 3, 400, 400), lic);
            const double before = standardDeviation(valuesOf(stages.convolve(lic)));
            stages.backend->smooth(lic, wholeImage(stages.view.camera));
            EXPECT_NEAR(standardDeviation(valuesOf(stages.backend->probe().lic())) / before, 1, 0.1)
                << steps << (kernel == Kernel::box ? " steps, box" : " steps, Hann");
        }
}

}  // namespace
}  // namespace aeolic
