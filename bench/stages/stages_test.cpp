#include "stages/stages.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/load/loaded_scene.h"
#include "description/camera.h"
#include "engine/tile_picture.h"
#include "stages/frame_stages.h"
#include "stages/stages_report.h"

namespace aeolic {
namespace {

StagesBenchPlan smallPlan()
{
    StagesBenchPlan plan;
    plan.scene.surface.spec = "sphere:2000";
    plan.scene.field.spec = "rotation:8,8,8";
    plan.scene.run.threads = 2;
    plan.sizes = {{60, 40}, {33, 57}};
    plan.steps = {4, 20};
    plan.repeats = plan.rateRepeats = 2;
    return plan;
}

TEST(BenchStages, EveryCombinationOnceInOrder)
{
    const StagesBenchPlan plan = smallPlan();
    const StagesBench bench = benchStages(plan);
    EXPECT_EQ(bench.threads, 2);
    ASSERT_EQ(bench.rows.size(), 2u * 2u * 2u);
    std::size_t at = 0;
    for (const auto& size : plan.sizes)
        for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical})
            for (const int steps : plan.steps) {
                const StagesBenchRow& row = bench.rows[at++];
                EXPECT_EQ(row.size.width, size.width);
                EXPECT_EQ(row.size.height, size.height);
                EXPECT_EQ(row.method, method);
                EXPECT_EQ(row.steps, steps);
            }
}

/// What is measured is the frame the renderer draws.
TEST(BenchStages, CoversTheRenderersPixels)
{
    const StagesBenchPlan plan = smallPlan();
    const StagesBench bench = benchStages(plan);
    SceneDescription scene = plan.scene;
    scene.output.width = plan.sizes[0].width;
    scene.output.height = plan.sizes[0].height;
    Renderer renderer(scene);
    renderer.render({scene.camera});
    EXPECT_GT(bench.rows[0].coveredPixels, 500);
    EXPECT_EQ(bench.rows[0].coveredPixels, renderer.lastFrame().coveredPixels);
}

/// Every stage, or the picture would be another.
TEST(BenchStages, DrawsTheRenderersPicture)
{
    SceneDescription d = smallPlan().scene;
    d.surface.spec = "teapot:2000";
    d.output.width = 80;
    d.output.height = 60;
    d.shading.occlusion = true;
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        d.lic.method = method;
        const Picture expected = Renderer(d).render({d.camera});
        const Scene scene = loadScene(d);
        const auto backend = makeBackend(BackendChoice::cpu, scene);
        const FrameRequest request{makeCamera(d.camera, scene.boundsWorld, scene.fitRadius, 80, 60, scene.reach), d.lic,
                                   d.shading};
        FrameTiles drawn;
        drawn.stripe.resize({0, 0, 80, 60});
        startStages(request, scene, *backend, drawn.stripe);
        backend->finish();
        EXPECT_EQ(gatheredPicture(drawn, 60).pixels, expected.pixels) << int(method);
    }
}

/// Hollows need what a stage of their own leaves.
TEST(BenchStages, MeasuresScenesWithOcclusion)
{
    StagesBenchPlan plan = smallPlan();
    plan.scene.shading.occlusion = true;
    for (const StagesBenchRow& row : benchStages(plan).rows) EXPECT_GT(row.shadeMs, 0);
}

TEST(BenchStages, RatesFollowFromTimesAndCounts)
{
    const StagesBench bench = benchStages(smallPlan());
    ASSERT_TRUE(bench.gatherRates);
    for (const StagesBenchRow& row : bench.rows) {
        EXPECT_GT(row.projectMs, 0);
        EXPECT_GT(row.convolveMs, 0);
        EXPECT_GT(row.shadeMs, 0);
        EXPECT_GE(row.totalMs, std::max({row.projectMs, row.convolveMs, row.shadeMs}));
        const double traces = 2.0 * double(row.coveredPixels), seconds = row.convolveMs * 1e-3;
        EXPECT_DOUBLE_EQ(row.pixelStepsPerS, traces * row.steps / seconds);
        if (row.method == LicMethod::direct) {  // RK2: two blocks of four lanes a step.
            EXPECT_NEAR(row.mostLanesPerS, traces * row.steps * 8 / seconds, 1e-9 * row.mostLanesPerS);
        }
        EXPECT_GT(row.walkedShare, 0.3);
        EXPECT_LE(row.walkedShare, 1);
        EXPECT_GT(row.lanesPerS, 0);
        EXPECT_LE(row.lanesPerS, row.mostLanesPerS * (1 + 1e-12));
        EXPECT_DOUBLE_EQ(row.shareOfGatherRate, row.lanesPerS / bench.gatherRates->gather.allThreads);
        EXPECT_DOUBLE_EQ(row.shareOfBlockRate, row.lanesPerS / bench.gatherRates->blocks.allThreads);
    }
}

TEST(BenchStages, LongerKernelsEndEarlierOnASmallSurface)
{
    StagesBenchPlan plan = smallPlan();
    plan.sizes = {{60, 40}};
    plan.steps = {4, 400};
    const StagesBench bench = benchStages(plan);
    EXPECT_GT(bench.rows[0].walkedShare, bench.rows[1].walkedShare + 0.1);
}

TEST(BenchStages, EmptyViewIsAllZeroRates)
{
    StagesBenchPlan plan = smallPlan();
    plan.scene.camera.position = Vec3{0, -20, 0};
    plan.scene.camera.focal = Vec3{0, -30, 0};
    for (const StagesBenchRow& row : benchStages(plan).rows) {
        EXPECT_EQ(row.coveredPixels, 0);
        EXPECT_EQ(row.pixelStepsPerS, 0);
        EXPECT_EQ(row.walkedShare, 0);
        EXPECT_EQ(row.lanesPerS, 0);
        EXPECT_EQ(row.mostLanesPerS, 0);
    }
}

TEST(BenchStages, FillWideCoversWidePicturesLikeSquareOnes)
{
    StagesBenchPlan plan = smallPlan();
    plan.sizes = {{120, 120}, {160, 90}};
    plan.steps = {4};
    plan.methods = {LicMethod::hierarchical};
    plan.fillWide = true;
    plan.scene.camera.zoom = 0.7;  // The sphere stays within both.
    const StagesBench bench = benchStages(plan);
    const auto covered = [&](std::size_t i) {
        const StagesBenchRow& row = bench.rows[i];
        return double(row.coveredPixels) / (double(row.size.width) * row.size.height);
    };
    EXPECT_NEAR(covered(0), covered(1), 0.02);
}

TEST(BenchStages, ProgressRisesFromZeroAndNamesWhatComes)
{
    std::vector<double> fractions;
    std::string last;
    benchStages(smallPlan(), {.progress = [&](const std::string& what, double fraction) {
                    fractions.push_back(fraction);
                    last = what;
                }});
    ASSERT_EQ(fractions.size(), 1u + 8u);
    EXPECT_EQ(fractions.front(), 0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.back(), 1);
    EXPECT_EQ(last, "33x57 hierarchical, 20 steps");
}

/// Who watches a measurement of minutes sees each row when it is measured, below a heading that is there before.
TEST(BenchStages, RowsAreShownAsTheyAreMeasured)
{
    const StagesBenchPlan plan = smallPlan();
    StagesTable table(plan);
    std::vector<std::string> shown;
    const StagesBench bench = benchStages(plan, {.more = [&](const StagesBench& soFar) {
                                              EXPECT_EQ(soFar.rows.size(), shown.size());
                                              shown.push_back(table.next(soFar));
                                          }});
    ASSERT_EQ(shown.size(), 1u + 8u);
    EXPECT_NE(shown[0].find("threads: 2\n"), std::string::npos) << shown[0];
    EXPECT_NE(shown[0].find("\nsize "), std::string::npos) << shown[0];
    for (std::size_t i = 0; i < 8; ++i) {
        const std::string row = shown[i + 1].substr(shown[i + 1].find_first_not_of('\n'));
        EXPECT_TRUE(row.starts_with(i < 4 ? "60x40 " : "33x57 ")) << row;
        EXPECT_EQ(std::count(row.begin(), row.end(), '\n'), 1) << row;
    }
    EXPECT_EQ(table.next(bench), "") << "everything was shown";
}

TEST(BenchStages, ImagesBeyondTheMemoryAreRefused)
{
    StagesBenchPlan plan = smallPlan();
    plan.sizes = {{10, 10}, {1 << 20, 1 << 20}};  // 96 TiB.
    EXPECT_THROW(benchStages(plan), InputError);
}

}  // namespace
}  // namespace aeolic
