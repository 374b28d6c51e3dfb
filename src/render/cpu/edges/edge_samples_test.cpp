#include "render/cpu/edges/edge_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

/// 1/depth is linear in pixels on a plane: at each sample it is the centre's, and its change times how far the sample
/// is from there, to the right and downwards.
TEST(EdgeSamples, HaveTheDepthWhereTheyLie)
{
    SurfaceMesh mesh =
        testkit::makeRectangle({-20, 20, 4.0 / 9}, {30, 0, 1}, {0, 30, 5.0 / 3});  // Triangle 0 is all that is seen.
    testkit::setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    const Scene scene = testkit::makeScene(std::move(mesh));
    const View view = makeView(testkit::frontCamera(scene, 12, 64, 48), scene, {});
    const SceneArrays arrays(scene);
    EdgeMask mask;
    mask.clear({0, 0, 64, 48});
    for (int y = 10; y < 40; ++y) mask.row(y)[0] = 0x0000'FFFF'00F0'1100;
    EdgePixels pixels;
    pixels.find(mask, mask.rows);
    testkit::forEachSimdTarget([&] {
        EdgeSamples samples;
        samples.drawn.clear(pixels);
        std::fill_n(samples.drawn.depths(), pixels.count() * antialias::kSamples, 1.0f);
        std::fill_n(samples.drawn.complements(), pixels.count() * antialias::kSamples, ~std::uint32_t{0});
        resolveSamples(arrays, view, samples);
        for (std::size_t i = 0; i < pixels.count(); ++i) {
            const auto at = [&](int s) { return i * antialias::kSamples + std::size_t(s); };
            const double gradX = double(samples.gradX[at(0)]), gradY = double(samples.gradY[at(0)]);
            ASSERT_GT(std::abs(gradX), 1e-5);
            ASSERT_GT(std::abs(gradY), 1e-5);
            const auto offset = [&](int s) {
                return (gradX * antialias::kRight[s] + gradY * antialias::kDown[s]) / antialias::kParts;
            };
            const double centre = double(samples.invDepth[at(0)]) - offset(0);
            for (int s = 0; s < antialias::kSamples; ++s)
                EXPECT_NEAR(double(samples.invDepth[at(s)]), centre + offset(s), 0.02 * std::abs(gradY)) << s;
        }
    });
}

}  // namespace
}  // namespace aeolic::cpu
