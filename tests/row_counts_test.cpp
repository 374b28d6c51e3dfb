#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "render_testing.h"

/// Balancers need to know how many pixels of each row the surface covers. It is counted before anything is drawn.
namespace aeolic {
namespace {

using namespace testkit;

class Coverage : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Coverage, allBackends, backendName);

std::vector<std::int64_t> coveredInRows(const GBuffer& buffer)
{
    const Extent& valid = buffer.valid();
    std::vector<std::int64_t> covered(std::size_t(valid.height()), 0);
    for (int y = 0; y < valid.height(); ++y)
        for (int x = 0; x < valid.width(); ++x) covered[std::size_t(y)] += buffer.invDepth.at(x, y) > 0;
    return covered;
}

std::int64_t sum(const std::vector<std::int64_t>& values)
{
    return std::accumulate(values.begin(), values.end(), std::int64_t{0});
}

Camera closeCamera(const Scene& scene, int width, int height)
{
    CameraOptions options;
    options.zoom = 1.3;
    return fitCamera(scene, options, width, height);
}

TEST_P(Coverage, AtFullResolutionIsThatOfThePicture)
{
    for (const char* surface : {"teapot:6000", "torus:900", "plane"})
        for (const auto& [width, height] : {std::pair(160, 131), std::pair(64, 64), std::pair(33, 200)}) {
            Stages stages(GetParam(), makeBuiltinScene(surface, "abc:8,8,8"));
            const GBuffer& buffer = stages.project(closeCamera(stages.scene, width, height), directLic(8));
            const std::vector<std::int64_t> covered = coveredInRows(buffer);
            EXPECT_EQ(stages.backend->coverage(stages.view, 1), covered) << surface << " " << width << "x" << height;
        }
}

/// A low-resolution pixel stands for a block of 5 x 5. Summed over the rows of a block, both counts differ only by
/// pixels of the outline.
TEST_P(Coverage, AtAFifthStandsForBlocksOfRows)
{
    constexpr int kFactor = 5;
    for (const auto& [width, height] : {std::pair(400, 400), std::pair(403, 397)}) {
        Stages stages(GetParam(), makeBuiltinScene("teapot:20000", "abc:8,8,8"));
        const GBuffer& buffer = stages.project(closeCamera(stages.scene, width, height), directLic(8));
        const std::vector<std::int64_t> fine = coveredInRows(buffer),
                                        coarse = stages.backend->coverage(stages.view, kFactor);
        ASSERT_EQ(coarse.size(), std::size_t((height + kFactor - 1) / kFactor));
        EXPECT_NEAR(double(sum(coarse) * kFactor * kFactor) / double(sum(fine)), 1, 0.02);
        for (std::size_t row = 0; row < coarse.size(); ++row) {
            std::int64_t block = 0;
            int rows = 0;
            for (std::size_t y = row * kFactor; y < std::min((row + 1) * kFactor, fine.size()); ++y, ++rows)
                block += fine[y];
            // At most four outlines cross the row of blocks, each through some of them.
            EXPECT_NEAR(double(coarse[row] * kFactor * rows), double(block), 12.0 * kFactor * kFactor) << row;
        }
    }
}

TEST_P(Coverage, OfAnEmptyViewIsZeroInEveryRow)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:800", "rotation:8,8,8"));
    CameraOptions away;
    away.position = Vec3{0, -20, 0};
    away.focal = Vec3{0, -30, 0};
    stages.project(fitCamera(stages.scene, away, 50, 31), directLic(8));
    EXPECT_EQ(stages.backend->coverage(stages.view, 5), std::vector<std::int64_t>(7, 0));
}

/// An image of less than one block is still counted, and counting leaves what is drawn afterwards alone.
TEST_P(Coverage, OfATinyImageAndBetweenFrames)
{
    Stages stages(GetParam(), makeBuiltinScene("plane", "abc:8,8,8"));
    const Camera camera = closeCamera(stages.scene, 3, 2);
    stages.project(camera, directLic(8));
    EXPECT_EQ(stages.backend->coverage(stages.view, 5).size(), 1u);
    const Camera larger = closeCamera(stages.scene, 90, 70);
    const std::vector<std::int64_t> before = coveredInRows(stages.project(larger, directLic(8)));
    stages.backend->coverage(stages.view, 5);
    EXPECT_EQ(coveredInRows(stages.project(larger, directLic(8))), before);
}

}  // namespace
}  // namespace aeolic
