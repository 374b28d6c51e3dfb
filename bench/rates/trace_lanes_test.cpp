#include "rates/trace_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

using namespace testkit;

LicOptions hierarchicalLic(int steps)
{
    LicOptions lic;
    lic.method = LicMethod::hierarchical;
    lic.steps = steps;
    return lic;
}

TEST(TraceLanes, DirectFetchesABlockASample)
{
    EXPECT_EQ(TraceLanes(directLic(100, Integrator::euler)).most(), 100 * 1 * 4);
    EXPECT_EQ(TraceLanes(directLic(100, Integrator::rk2)).most(), 100 * 2 * 4);
    EXPECT_EQ(TraceLanes(directLic(100, Integrator::rk4)).most(), 100 * 4 * 4);
    // 30 steps taken and one that finds no way on.
    EXPECT_EQ(TraceLanes(directLic(100)).of(30), 31 * 2 * 4);
    EXPECT_EQ(TraceLanes(directLic(100)).of(0), 1 * 2 * 4);
}

TEST(TraceLanes, HierarchicalFetchesDirectStepsAndTwoBlocksALookup)
{
    for (const int steps : {1, 7, 8, 9, 16, 100, 128, 1000, 1024, 65536}) {
        const JumpPlan plan = planJumps(steps);
        EXPECT_EQ(TraceLanes(hierarchicalLic(steps)).most(), plan.direct * 4 + plan.lookups() * 8) << steps;
        LicOptions hann = hierarchicalLic(steps);
        hann.kernel = Kernel::hann;
        EXPECT_EQ(TraceLanes(hann).most(), plan.direct * 4 + plan.lookups() * 12) << steps;
    }
}

/// However a plan composes the kernel: a longer trace never fetches less, and one that ends at once looks no jump up.
TEST(TraceLanes, ShorterTracesFetchLess)
{
    for (const int steps : {16, 100, 128, 1000}) {
        const TraceLanes lanes(hierarchicalLic(steps));
        EXPECT_EQ(lanes.of(0), 4);
        for (int walked = 1; walked <= steps; ++walked) EXPECT_GE(lanes.of(walked), lanes.of(walked - 1));
        EXPECT_LT(lanes.of(steps / 4), lanes.most());
    }
}

TEST(TraceLanes, NoLicFetchesNothing)
{
    LicOptions lic;
    lic.method = LicMethod::none;
    EXPECT_EQ(TraceLanes(lic).most(), 0);
}

/// A plane that fills the picture under a flow along x: traces end at the picture's sides and nowhere else.
TEST(WalkedSteps, UniformFlowWalksToTheImagesBorder)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    Stages stages("cpu", makeScene(std::move(mesh)));
    const int width = 60, height = 40, steps = 25;
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 2, width, height), directLic(steps));
    const std::vector<int> walked = sampleWalkedSteps(buffer, steps, width * height);
    ASSERT_EQ(walked.size(), std::size_t(2 * width * height));
    for (int x = 0; x < width; ++x) {
        // To the right, then to the left. A step is a pixel long but for its rounding to flow units.
        EXPECT_NEAR(walked[std::size_t(2 * x)], std::min(steps, width - 1 - x), 1) << x;
        EXPECT_NEAR(walked[std::size_t(2 * x + 1)], std::min(steps, x), 1) << x;
    }
}

TEST(WalkedSteps, SamplesAboutAsManyPixelsAsAsked)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(0, 1, 0); });
    Stages stages("cpu", makeScene(std::move(mesh)));
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 2, 300, 200), directLic(4));
    EXPECT_NEAR(double(sampleWalkedSteps(buffer, 4, 600).size()), 2 * 600.0, 2 * 120.0);
}

TEST(WalkedSteps, EmptyViewAndZeroVectorWalkNothing)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    setPointVectors(mesh, [](const glm::dvec3& p) { return p.x < 0 ? glm::vec3(0) : glm::vec3(0, 1, 0); });
    Stages stages("cpu", makeScene(std::move(mesh)));
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 2, 40, 40), directLic(4));
    for (int x = 0; x < 10; ++x) ASSERT_NE(buffer.flow.at(x, 20), 0u) << "covered, without motion";
    const std::vector<int> walked = sampleWalkedSteps(buffer, 4, 1600);
    EXPECT_EQ(walked[0], 0);
    EXPECT_GT(*std::max_element(walked.begin(), walked.end()), 2);

    CameraOptions away;
    away.position = Vec3{0, -20, 0};
    away.focal = Vec3{0, -30, 0};
    const GBuffer& empty = stages.project(fitCamera(stages.scene, away, 40, 40), directLic(4));
    EXPECT_TRUE(sampleWalkedSteps(empty, 4, 1600).empty());
}

}  // namespace
}  // namespace aeolic::cpu
