#include "render/cpu/edges/edge_samples.h"

#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

/// Two triangles of a piece stand at places of their own in the whole surface, which decide what shows where several
/// ranks' are equally near.
TEST(SeenEdges, SamplesHaveTheirTrianglesPlaceInTheWholeSurface)
{
    SurfaceMesh mesh = testkit::makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    testkit::setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    constexpr std::uint64_t kFirst = 70, kSecond = std::uint64_t{1} << 40;
    mesh.order = {kFirst, kSecond};
    const Scene scene = testkit::makeScene(std::move(mesh));
    const View view = makeView(testkit::frontCamera(scene, 6, 64, 64), scene, {});
    const SceneArrays arrays(scene);
    EdgeMask all;
    all.clear({0, 0, 64, 64});
    for (int y = 0; y < 64; ++y) all.row(y)[0] = std::uint64_t{1} << y | std::uint64_t{1} << (63 - y);
    Visibility visibility;
    visibility.binEdges(arrays, view, all.rows, all);

    std::map<std::uint64_t, int> count;
    for (const EdgePixelSeen& pixel : seenInEdges(visibility, all, arrays, view))
        for (const EdgeSample& sample : pixel.samples) {
            if (sample.depth == 0) continue;
            EXPECT_GT(std::bit_cast<float>(sample.depth), 0);
            ++count[sample.order];
        }
    EXPECT_EQ(count.size(), 2u);
    EXPECT_GT(count[kFirst], 50);
    EXPECT_GT(count[kSecond], 50);
}

TEST(EdgeSample, OfEquallyNearOnesTheFirstOfTheWholeSurfaceHides)
{
    const auto sample = [](std::uint32_t depth, std::uint64_t order) {
        EdgeSample one;
        one.depth = depth;
        one.order = order;
        return one;
    };
    EXPECT_TRUE(sample(3, 9).hides(sample(2, 1))) << "nearer";
    EXPECT_FALSE(sample(2, 1).hides(sample(3, 9)));
    EXPECT_TRUE(sample(3, 1).hides(sample(3, 2)));
    EXPECT_FALSE(sample(3, 2).hides(sample(3, 1)));
    EXPECT_FALSE(sample(3, 1).hides(sample(3, 1)));
    EXPECT_TRUE(sample(1, 5).hides({})) << "before nothing";
    EXPECT_FALSE(EdgeSample{}.hides(sample(1, 5)));
    EXPECT_FALSE(sample(0, 0).hides(sample(0, 1)));
}

}  // namespace
}  // namespace aeolic::cpu
