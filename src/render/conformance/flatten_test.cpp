#include "render/flatten.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/reference.h"
#include "render_testing.h"

/// The last step of even streaks: no patch of the picture is darker or lighter than another.
namespace aeolic {
namespace {

using namespace testkit;

class Flatten : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Flatten, allBackends, backendName);

std::vector<double> valuesOf(const Image<float>& image)
{
    const Extent& extent = image.valid();
    std::vector<double> values;
    for (int y = extent.y0; y < extent.y1; ++y)
        for (int x = extent.x0; x < extent.x1; ++x) values.push_back(double(image.at(x, y)));
    return values;
}

/// Silhouettes, sheets that hide each other, the picture's border, places without flow.
TEST_P(Flatten, IsWhatTheReferenceMakesOfTheSameValues)
{
    for (const char* surface : {"teapot:3000", "torus:3000"})
        for (const double noiseScale : {1.0, 0.5}) {
            Stages stages(GetParam(), makeBuiltinScene(surface, "tornado:24,24,24"));
            LicOptions lic = directLic(24);
            lic.noiseScale = noiseScale;
            CameraOptions close;
            close.zoom = 1.5;
            const GBuffer& buffer = stages.project(fitCamera(stages.scene, close, 133, 90), lic);
            const std::vector<double> before = valuesOf(stages.convolve(lic));
            const std::vector<double> expected =
                reference::flatten(reference::fromGBuffer(buffer), before, noiseScale == 1 ? 12 : 24);
            stages.backend->flatten(lic, wholeImage(stages.view.camera));
            const std::vector<double> found = valuesOf(stages.backend->probe().lic());
            double farthest = 0, changed = 0;
            for (std::size_t i = 0; i < found.size(); ++i) {
                farthest = std::max(farthest, std::abs(found[i] - expected[i]));
                changed += std::abs(found[i] - before[i]) > 0.01;
            }
            EXPECT_LT(farthest, 2e-3) << surface;
            EXPECT_GT(changed, 1000) << surface;
        }
}

/// One value for all is taken off whole, however far from 0: patches have no tone of their own.
TEST_P(Flatten, TakesOffWhatAllHaveInCommon)
{
    SurfaceMesh plane = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    setPointVectors(plane, [](const glm::dvec3&) { return glm::vec3(1, 0.3, 0); });
    Stages stages(GetParam(), makeScene(std::move(plane)));
    const LicOptions lic = directLic(20);
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 6, 60, 50), lic);
    Image<float> values;
    values.resize(stages.convolve(lic).valid());
    for (const float common : {0.75f, -6.0f}) {
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 60; ++x) values.at(x, y) = buffer.flow.at(x, y) == 0 ? 0 : common;
        stages.backend->probe().setLic(values);
        stages.backend->flatten(lic, wholeImage(stages.view.camera));
        const Image<float>& found = stages.backend->probe().lic();
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 60; ++x) ASSERT_NEAR(found.at(x, y), 0, 1e-6) << x << ' ' << y;
    }
}

/// Values that no kernel gives are bounded where they are summed up, and else left alone.
TEST_P(Flatten, BearsAnyValue)
{
    SurfaceMesh plane = makeRectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    setPointVectors(plane, [](const glm::dvec3&) { return glm::vec3(1, 0.3, 0); });
    Stages stages(GetParam(), makeScene(std::move(plane)));
    const LicOptions lic = directLic(20);
    stages.project(frontCamera(stages.scene, 3, 60, 50), lic);
    Image<float> values;
    values.resize(stages.convolve(lic).valid());
    for (int y = 0; y < 50; ++y) std::fill_n(&values.at(0, y), 60, 1e6f);
    stages.backend->probe().setLic(values);
    stages.backend->flatten(lic, wholeImage(stages.view.camera));
    EXPECT_NEAR(stages.backend->probe().lic().at(30, 25), (1e6f - 64) * flatten::kGain, 1);
}

TEST_P(Flatten, LeavesPlainStreaksAlone)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:3000", "abc:16,16,16"));
    LicOptions lic = directLic(24);
    lic.streaks = Streaks::plain;
    stages.project(fitCamera(stages.scene, {}, 90, 70), lic);
    const std::vector<double> before = valuesOf(stages.convolve(lic));
    stages.backend->flatten(lic, wholeImage(stages.view.camera));
    EXPECT_EQ(valuesOf(stages.backend->probe().lic()), before);
}

/// A square of 25 x 25 pixels has next to no tone of its own afterwards, and streaks keep nearly all their contrast.
TEST_P(Flatten, LeavesStreaksWhatTheyAre)
{
    SurfaceMesh plane = makeRectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    setPointVectors(plane, [](const glm::dvec3&) { return glm::vec3(0.9, 0.3, 0); });
    Stages stages(GetParam(), makeScene(std::move(plane)));
    const LicOptions lic = directLic(100);
    const int side = 200;
    stages.project(frontCamera(stages.scene, 3, side, side), lic);
    const auto meansOf = [&](const std::vector<double>& values) {
        std::vector<double> means;
        for (int y = 0; y + 25 <= side; y += 25)
            for (int x = 0; x + 25 <= side; x += 25) {
                double sum = 0;
                for (int v = 0; v < 25; ++v)
                    for (int u = 0; u < 25; ++u) sum += values[std::size_t((y + v) * side + x + u)];
                means.push_back(sum / 625);
            }
        return means;
    };
    const std::vector<double> before = valuesOf(stages.convolve(lic));
    stages.backend->flatten(lic, wholeImage(stages.view.camera));
    const std::vector<double> after = valuesOf(stages.backend->probe().lic());
    EXPECT_LE(standardDeviation(meansOf(after)), 0.5 * standardDeviation(meansOf(before)));
    EXPECT_NEAR(standardDeviation(after), standardDeviation(before), 0.03 * standardDeviation(before));
    EXPECT_GE(correlation(before, after), 0.93);
}

}  // namespace
}  // namespace aeolic
