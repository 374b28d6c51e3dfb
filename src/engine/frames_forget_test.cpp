#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render_testing.h"
#include "same_bytes_testing.h"

/// Memory is kept between frames. Only memory that is read is cleared: no picture shows anything of the one before.
namespace aeolic {
namespace {

using namespace testkit;

class FramesForget : public BackendTest {
protected:
    /// What a program on the processor plays the GPU in, it plays slowly. Its tiles are smaller, too.
    static int pixels(int gpu, int cpu) { return GetParam() == "gl" ? gpu : cpu; }
};
INSTANTIATE_TEST_SUITE_P(Backends, FramesForget, allBackends, backendName);

/// The surface everywhere, small in the middle, in a corner, nowhere, small again, and from inside.
std::vector<CameraOptions> leaps()
{
    CameraOptions filling, small, corner, nowhere, inside;
    filling.zoom = 5;
    small.zoom = 0.2;
    corner.position = Vec3{8, -6, 14};
    corner.focal = Vec3{6, -4, 0};
    nowhere.position = Vec3{0, -40, 0};
    nowhere.focal = Vec3{0, -80, 0};
    inside.position = Vec3{0.2, 0.1, 0.5};
    inside.focal = Vec3{1, 0.3, 0.6};
    return {filling, small, filling, corner, filling, nowhere, small, inside, small};
}

/// Each picture is the one that a program sees which draws no other before it.
void expectFresh(const std::string& backend, const Case& c, const std::vector<CameraOptions>& cameras,
                 const std::vector<Picture>& fresh, const RunOptions& options, int ranks)
{
    const std::vector<Picture> pictures = draw(backend, c, options, ranks, cameras);
    ASSERT_EQ(pictures.size(), fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i)
        EXPECT_EQ(pictures[i].pixels, fresh[i].pixels)
            << (c.description.lic.method == LicMethod::direct ? "direct" : "hierarchical") << ", view " << i << ", "
            << ranks << " ranks";
}

std::vector<Picture> drawnFresh(const std::string& backend, const Case& c, const std::vector<CameraOptions>& cameras)
{
    std::vector<Picture> fresh;
    fresh.reserve(cameras.size());
    for (const CameraOptions& camera : cameras) fresh.push_back(draw(backend, c, {}, 1, std::vector{camera}).front());
    return fresh;
}

TEST_P(FramesForget, WhateverWasThereBefore)
{
    const std::vector<CameraOptions> cameras = leaps();
    for (const LicOptions& lic : {licOf(LicMethod::hierarchical, 60), licOf(LicMethod::direct, 20)}) {
        const Case c = makeCase("leaps", pixels(151, 231), pixels(106, 170), lic);
        const std::vector<Picture> fresh = drawnFresh(GetParam(), c, cameras);
        expectFresh(GetParam(), c, cameras, fresh, {}, 1);
        expectFresh(GetParam(), c, cameras, fresh, runOptions("hybrid", "bound", "receive"), 3);
        expectFresh(GetParam(), c, cameras, fresh, runOptions("pixels", "bound", "project"), 2);
        expectFresh(GetParam(), c, cameras, fresh, runOptions("static", "estimate", "receive", "on"), 3);
    }
}

/// A hole many tiles wide: background with surface on both sides.
TEST_P(FramesForget, WhereASurfaceHasAHole)
{
    CameraOptions filling, throughTheHole;
    filling.zoom = 20;
    throughTheHole.elevation = 85;
    for (const LicOptions& lic : {licOf(LicMethod::hierarchical, 30), licOf(LicMethod::direct, 10)}) {
        const int side = pixels(360, 900);
        const Case c = makeCase("hole", side, side, lic, "torus:4000");
        const std::vector<CameraOptions> cameras{filling, throughTheHole};
        const std::vector<Picture> fresh = drawnFresh(GetParam(), c, cameras);
        expectFresh(GetParam(), c, cameras, fresh, {}, 1);
        expectFresh(GetParam(), c, cameras, fresh, runOptions("hybrid", "estimate", "receive"), 3);
    }
}

}  // namespace
}  // namespace aeolic
