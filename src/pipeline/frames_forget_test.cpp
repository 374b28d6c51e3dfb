#include <gtest/gtest.h>

#include <vector>

#include "render_testing.h"
#include "same_bytes_testing.h"

/// Memory is kept between frames and only what is read is cleared: no picture shows anything of the one before.
namespace aeolic {
namespace {

using namespace testkit;

class FramesForget : public BackendTest {};
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

TEST_P(FramesForget, WhateverWasThereBefore)
{
    const std::vector<CameraOptions> cameras = leaps();
    for (const LicOptions& lic : {licOf(LicMethod::hierarchical, 60), licOf(LicMethod::direct, 20)}) {
        const Case c = makeCase("leaps", 231, 170, lic);
        std::vector<Tile> fresh;
        for (const CameraOptions& camera : cameras)
            fresh.push_back(draw(GetParam(), c, {}, 1, std::vector{camera}).front());
        const auto expectFresh = [&](const RunOptions& options, int ranks) {
            const std::vector<Tile> pictures = draw(GetParam(), c, options, ranks, cameras);
            ASSERT_EQ(pictures.size(), fresh.size());
            for (std::size_t i = 0; i < fresh.size(); ++i)
                EXPECT_EQ(pictures[i].rgba, fresh[i].rgba)
                    << (lic.method == LicMethod::direct ? "direct" : "hierarchical") << ", view " << i << ", " << ranks
                    << " ranks";
        };
        expectFresh({}, 1);
        expectFresh(runOptions("hybrid", "bound", "receive"), 3);
        expectFresh(runOptions("pixels", "bound", "project"), 2);
        expectFresh(runOptions("static", "estimate", "receive", "on"), 3);
    }
}

}  // namespace
}  // namespace aeolic
