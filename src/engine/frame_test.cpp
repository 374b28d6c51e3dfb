#include "engine/frame.h"
#include "description/choices.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "cluster/comm/communicator.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

class Frame : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Frame, allBackends, backendName);

/// One frame by a group of one.
Tile renderAlone(const FrameRequest& request, const Scene& scene, Backend& backend, FrameStats& stats)
{
    FrameGroup group(makeSerialCommunicator(), {});
    aeolic::Frame frame;
    renderFrame(request, scene, backend, group, frame);
    stats = frame.stats;
    return frame.tiles.stripe;
}

FrameRequest requestFor(const Scene& scene, LicMethod method, int width, int height)
{
    FrameRequest request{fitCamera(scene, {}, width, height), directLic(40), {}};
    request.lic.method = method;
    return request;
}

TEST_P(Frame, SameBytesFromAnyNumberOfThreads)
{
    const tbb::global_control allowEight(tbb::global_control::max_allowed_parallelism,
                                         8);  // Even where there are fewer cores.
    const Scene scene = makeBuiltinScene("teapot:20000", "abc:32,32,32");
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const FrameRequest request = requestFor(scene, method, 213, 171);
        std::vector<std::uint8_t> first;
        for (const int threads : {1, 2, 3, 8}) {
            tbb::task_arena arena(threads);
            arena.execute([&] {
                const auto backend = makeBackend(*choiceNamed<BackendChoice>(GetParam()), scene);
                FrameStats stats;
                const Tile tile = renderAlone(request, scene, *backend, stats);
                if (first.empty()) first = tile.rgba;
                EXPECT_TRUE(tile.rgba == first) << threads << " threads";
            });
        }
    }
}

/// Memory that the backend keeps from frame to frame does not show, whatever was drawn in between.
TEST_P(Frame, RepeatedFramesAreIdentical)
{
    const Scene scene = makeBuiltinScene("teapot:20000", "abc:32,32,32");
    const auto backend = makeBackend(*choiceNamed<BackendChoice>(GetParam()), scene);
    FrameStats stats;
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const FrameRequest request = requestFor(scene, method, 150, 130);
        const Tile first = renderAlone(request, scene, *backend, stats);
        EXPECT_TRUE(renderAlone(request, scene, *backend, stats).rgba == first.rgba);
        for (const auto& [width, height] : {std::pair(31, 17), std::pair(300, 200), std::pair(1, 400)})
            renderAlone(requestFor(scene, LicMethod::direct, width, height), scene, *backend, stats);
        FrameRequest other = request;
        other.lic.steps = 200;
        other.lic.style = Style::oriented;
        renderAlone(other, scene, *backend, stats);
        other.lic.style = Style::dense;
        other.lic.kernel = Kernel::hann;
        renderAlone(other, scene, *backend, stats);
        EXPECT_TRUE(renderAlone(request, scene, *backend, stats).rgba == first.rgba);
    }
}

TEST_P(Frame, StatsCountTheCoveredPixels)
{
    const Scene scene = makeBuiltinScene("sphere:2000", "rotation:8,8,8");
    const auto backend = makeBackend(*choiceNamed<BackendChoice>(GetParam()), scene);
    FrameRequest request = requestFor(scene, LicMethod::direct, 90, 70);
    request.shading.background = "transparent";
    request.shading.antialias = false;
    FrameStats stats;
    const Tile tile = renderAlone(request, scene, *backend, stats);
    std::int64_t opaque = 0;
    for (std::size_t i = 3; i < tile.rgba.size(); i += 4) opaque += tile.rgba[i] == 255;
    EXPECT_EQ(stats.coveredPixels, opaque);
    EXPECT_GT(opaque, 1000);
    EXPECT_GE(stats.totalMs, stats.projectMs + stats.convolveMs + stats.shadeMs);
    EXPECT_GT(stats.projectMs, 0);
    EXPECT_GT(stats.busyMs, 0);
}

TEST_P(Frame, EmptyViewIsAllBackground)
{
    const Scene scene = makeBuiltinScene("sphere:800", "rotation:8,8,8");
    const auto backend = makeBackend(*choiceNamed<BackendChoice>(GetParam()), scene);
    CameraOptions away;
    away.position = Vec3{0, -20, 0};
    away.focal = Vec3{0, -30, 0};
    for (const LicMethod method : {LicMethod::none, LicMethod::direct, LicMethod::hierarchical}) {
        FrameRequest request{fitCamera(scene, away, 40, 30), directLic(20), {}};
        request.lic.method = method;
        request.shading.background = "102030";
        FrameStats stats;
        const Tile tile = renderAlone(request, scene, *backend, stats);
        EXPECT_EQ(stats.coveredPixels, 0);
        for (std::size_t i = 0; i < tile.rgba.size(); i += 4) {
            ASSERT_EQ(tile.rgba[i], 0x10);
            ASSERT_EQ(tile.rgba[i + 1], 0x20);
            ASSERT_EQ(tile.rgba[i + 2], 0x30);
            ASSERT_EQ(tile.rgba[i + 3], 255);
        }
    }
}

}  // namespace
}  // namespace aeolic
