#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "render_testing.h"

/// Vectors that are zero, masked, or not there at all.
namespace aeolic {
namespace {

using namespace testkit;

class OddFields : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, OddFields, allBackends, backendName);

const float kNan = std::numeric_limits<float>::quiet_NaN();

TEST_P(OddFields, ZeroVectorsShowTheBareNoise)
{
    for (const bool normalize : {true, false}) {
        SurfaceMesh mesh = makeBuiltinScene("sphere:800", "uniform:2,2,2").surface;
        setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(0); });
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        LicOptions lic = directLic(32);
        lic.normalize = normalize;
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 60, 50), lic);
        const Image<float>& found = stages.convolve(lic);
        std::vector<double> noise, values;
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 60; ++x) {
                if (buffer.flow.at(x, y) == 0) continue;
                EXPECT_EQ(flow_texel::dx(buffer.flow.at(x, y)), 0);
                EXPECT_EQ(flow_texel::dy(buffer.flow.at(x, y)), 0);
                noise.push_back(double(flow_texel::noise(buffer.flow.at(x, y)) - flow_texel::kNoiseZero) / 127);
                values.push_back(double(found.at(x, y)));
            }
        ASSERT_GT(values.size(), 1000u);
        const Fit fit = fitGain(noise, values);
        EXPECT_GT(fit.gain, 1);
        EXPECT_LT(fit.worst, 1e-4);
    }
}

/// Masked samples and places outside the field: the surface is there, the flow is not, and traces end before it.
TEST_P(OddFields, FieldMaskedOrSmallerThanTheSurface)
{
    const Bounds around{{-2, -2, -1}, {2, 2, 1}}, left{{-2, -2, -1}, {0, 2, 1}};
    const auto masked = makeField(around, {33, 9, 5},
                                  [](const glm::dvec3& p) { return p.x > 0 ? glm::vec3(kNan) : glm::vec3(1, 0.2, 0); });
    const auto smaller = makeField(left, {17, 9, 5}, [](const glm::dvec3&) { return glm::vec3(1, 0.2, 0); });
    for (const auto& field : {masked, smaller}) {
        Stages stages(GetParam(), makeScene(makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2), field));
        const LicOptions lic = directLic(40);
        const GBuffer& buffer = stages.project(frontCamera(stages.scene, 4, 80, 60), lic);
        const Image<float>& found = stages.convolve(lic);
        int withFlow = 0, without = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x) {
                if (!(buffer.invDepth.at(x, y) > 0)) continue;
                const double position = positionAt(stages.view.camera, double(buffer.invDepth.at(x, y)), x, y).x;
                ASSERT_TRUE(std::isfinite(found.at(x, y)));
                if (position > 0.01) {
                    ++without;
                    EXPECT_EQ(buffer.flow.at(x, y), 0u) << x << "," << y;
                    EXPECT_EQ(found.at(x, y), 0) << x << "," << y;
                } else if (position < -0.01) {
                    ++withFlow;
                    EXPECT_NE(buffer.flow.at(x, y), 0u) << x << "," << y;
                }
            }
        EXPECT_GT(withFlow, 300);
        EXPECT_GT(without, 300);
    }
}

TEST_P(OddFields, MaskedCellsOfTheSurface)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 6);
    setCellVectors(mesh, [](const glm::dvec3& p) { return p.y > 0 ? glm::vec3(kNan) : glm::vec3(0, 1, 0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    const LicOptions lic = directLic(40);
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 4, 60, 60), lic);
    const Image<float>& found = stages.convolve(lic);
    for (int x = 20; x < 40; ++x) {
        EXPECT_GT(buffer.invDepth.at(x, 25), 0);
        EXPECT_EQ(buffer.flow.at(x, 25), 0u);
        EXPECT_EQ(found.at(x, 25), 0);
        EXPECT_NE(buffer.flow.at(x, 35), 0u);
        EXPECT_TRUE(std::isfinite(found.at(x, 35)));
    }
}

}  // namespace
}  // namespace aeolic
