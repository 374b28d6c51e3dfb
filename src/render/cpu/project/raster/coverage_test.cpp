#include "render/cpu/project/raster/coverage.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

using namespace testkit;

std::vector<std::int64_t> countRows(const Scene& scene, const Camera& camera)
{
    const SceneArrays arrays(scene);
    CoverageCount coverage;
    return coverage.draw(arrays, makeView(camera, scene, {})).pixelsPerRow();
}

/// What the projection stage says.
std::vector<std::int64_t> projectRows(const Scene& scene, const Camera& camera)
{
    const auto backend = makeBackend(BackendChoice::cpu, scene);
    backend->project(makeView(camera, scene, {}), wholeImage(camera));
    const GBuffer& buffer = backend->probe().gbuffer();
    std::vector<std::int64_t> covered;
    for (int y = 0; y < camera.height; ++y) {
        covered.push_back(0);
        for (int x = 0; x < camera.width; ++x) covered.back() += buffer.invDepth.at(x, y) > 0;
    }
    return covered;
}

TEST(Coverage, IsWhatTheProjectionDraws)
{
    // From triangles much smaller than a pixel to some of hundreds.
    for (const char* surface : {"teapot:20000", "sphere:48", "torus:200000", "plane:2"}) {
        const Scene scene = makeBuiltinScene(surface, "abc:8,8,8");
        for (const auto& [width, height] :
             {std::pair(160, 160), std::pair(63, 31), std::pair(1, 200), std::pair(900, 400)}) {
            const Camera camera = fitCamera(scene, {}, width, height);
            EXPECT_EQ(countRows(scene, camera), projectRows(scene, camera)) << surface << " " << width << "x" << height;
        }
    }
}

TEST(Coverage, OfASurfaceAroundTheCamera)
{
    const Scene scene = makeBuiltinScene("sphere:2000", "abc:8,8,8");
    CameraOptions inside;
    inside.position = Vec3{0.2, 0.1, 0};
    inside.focal = Vec3{1, 0.3, 0.2};
    inside.fov = 120;
    const Camera camera = fitCamera(scene, inside, 150, 90);
    const std::vector<std::int64_t> rows = countRows(scene, camera);
    EXPECT_EQ(rows, projectRows(scene, camera));
    EXPECT_EQ(rows[45], 150);
}

TEST(Coverage, TheSameFromAnyNumberOfThreads)
{
    const tbb::global_control allowEight(tbb::global_control::max_allowed_parallelism, 8);
    const Scene scene = makeBuiltinScene("teapot:100000", "abc:8,8,8");
    const Camera camera = fitCamera(scene, {}, 300, 200);
    const std::vector<std::int64_t> expected = projectRows(scene, camera);
    tbb::task_arena arena(8);
    arena.execute([&] {
        for (int i = 0; i < 5; ++i) EXPECT_EQ(countRows(scene, camera), expected);
    });
}

TEST(Coverage, KeepsNothingOfTheFrameBefore)
{
    const Scene scene = makeBuiltinScene("teapot:2000", "abc:8,8,8");
    const SceneArrays arrays(scene);
    CoverageCount coverage;
    CameraOptions close, away;
    close.zoom = 4;
    away.position = Vec3{0, -20, 0};
    away.focal = Vec3{0, -30, 0};
    coverage.draw(arrays, makeView(fitCamera(scene, close, 200, 100), scene, {}));
    const CoverageBits& covered = coverage.draw(arrays, makeView(fitCamera(scene, away, 90, 50), scene, {}));
    EXPECT_EQ(covered.pixelsPerRow(), std::vector<std::int64_t>(50, 0));
}

TEST(Coverage, PartsTogetherAreTheWholeWhateverTheirNumber)
{
    for (const char* surface : {"teapot:20000", "sphere:48", "plane:2"}) {
        const Scene scene = makeBuiltinScene(surface, "abc:8,8,8");
        const SceneArrays arrays(scene);
        const View view = makeView(fitCamera(scene, {}, 203, 97), scene, {});
        CoverageCount coverage;
        const CoverageBits whole = coverage.draw(arrays, view);
        for (const int parts : {1, 2, 7, 1000}) {
            CoverageBits together;
            together.clear(203, 97);
            for (int part = 0; part < parts; ++part) {
                const CoverageBits& bits = coverage.draw(arrays, view, part, parts);
                ASSERT_EQ(bits.words.size(), together.words.size());
                for (std::size_t i = 0; i < bits.words.size(); ++i) together.words[i] |= bits.words[i];
            }
            EXPECT_EQ(together.words, whole.words) << surface << " in " << parts << " parts";
        }
    }
}

}  // namespace
}  // namespace aeolic::cpu
