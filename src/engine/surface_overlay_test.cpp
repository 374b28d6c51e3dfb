#include "render/surface_overlay.h"

#include <gtest/gtest.h>

#include "cluster/comm/communicator.h"
#include "description/choices.h"
#include "engine/frame.h"
#include "pieces_scenes_testing.h"
#include "render_testing.h"
#include "same_bytes_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

class Overlays : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Overlays, allBackends, backendName);

std::uint8_t byteOf(double part)
{
    return std::uint8_t(std::clamp(part * 255, 0.0, 255.0));
}

/// Everything that is seen, in one pixel of three: where it is, which way it is turned, how it flows. And a row of dots
/// over the background.
struct AllThatIsSeen final : SurfaceOverlay {
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override
    {
        const Extent& rows = seen.rows();
        for (int y = rows.y0; y < rows.y1; ++y)
            for (int x = rows.x0; x < rows.x1; ++x) {
                if (!seen.covered(x, y)) {
                    if (x % 16 == 3 && y % 8 == 2) out.put(x, y, {200, 0, 100, 255});
                    continue;
                }
                const glm::vec3 normal = seen.normal(view, x, y);
                const glm::vec2 step = seen.step(x, y).value_or(glm::vec2(0));
                const std::array<std::uint8_t, 4> colors[3] = {
                    {byteOf(0.5 + 0.5 * normal.x), byteOf(0.5 + 0.5 * normal.y), byteOf(0.5 + 0.5 * normal.z), 255},
                    {byteOf(0.5 + 0.2 * step.x), byteOf(0.5 + 0.2 * step.y), 0, 255},
                    {byteOf(view.nearDepth * view.unitWorld / seen.depth(view, x, y)), 0, 0, 255}};
                if (y % 3 == 0) out.put(x, y, colors[x % 3]);
            }
    }
};

Case overlaid(Case c)
{
    c.overlay = std::make_shared<AllThatIsSeen>();
    return c;
}

TEST_P(Overlays, SameBytesFromAnyNumberOfRanks)
{
    const Case plain = makeCase("plain", 96, 81, licOf(LicMethod::hierarchical, 20)), c = overlaid(plain);
    const std::vector<Picture> alone = draw(GetParam(), c, {}, 1, 2);
    EXPECT_NE(alone[0].pixels, draw(GetParam(), plain, {}, 1, 1)[0].pixels);
    for (const int ranks : {2, 3, 5}) {
        expectSameBytes(GetParam(), c, alone, runOptions("static", "bound", "project"), ranks);
        expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "estimate", "receive"), ranks);
    }
    expectSameBytes(GetParam(), c, alone, runOptions("hybrid", "bound", "auto", "on"), 3);
}

class OverlaysOfPieces : public testkit::PiecesTest {};

TEST_F(OverlaysOfPieces, SameBytesFromAnyNumberOfRanks)
{
    expectSame(overlaid(torus(licOf(LicMethod::hierarchical, 20), {}, "")), {2, 4}, {kHybrid});
}

/// Dots of a frame before do not stay where the next has none.
TEST_P(Overlays, LeaveNothingBehind)
{
    const Scene scene = makeBuiltinScene("sphere:2000", "rotation:8,8,8");
    const auto backend = makeBackend(*choiceNamed<BackendChoice>(GetParam()), scene);
    FrameGroup group(makeSerialCommunicator(), {});
    Frame frame;
    FrameRequest request{fitCamera(scene, {}, 60, 50), directLic(10), {}};
    renderFrame(request, scene, *backend, group, frame);
    const std::vector<std::uint8_t> before = frame.tiles.stripe.rgba;
    request.overlay = std::make_shared<AllThatIsSeen>();
    renderFrame(request, scene, *backend, group, frame);
    EXPECT_NE(frame.tiles.stripe.rgba, before);
    request.overlay = nullptr;
    renderFrame(request, scene, *backend, group, frame);
    EXPECT_EQ(frame.tiles.stripe.rgba, before);
}

/// A sphere that turns around the axis that the camera looks along.
TEST_P(Overlays, SeeDepthNormalsAndFlow)
{
    const Scene scene = makeBuiltinScene("sphere:100000", "rotation:16,16,16");
    const auto backend = makeBackend(*choiceNamed<BackendChoice>(GetParam()), scene);
    CameraOptions fromAbove;
    fromAbove.position = Vec3{0, 0, 5};
    fromAbove.focal = Vec3{0, 0, 0};
    fromAbove.up = Vec3{0, 1, 0};
    const Camera camera = fitCamera(scene, fromAbove, 101, 101);
    const View view = makeView(camera, scene, directLic(10));
    const Extent all{0, 0, 101, 101};
    backend->project(view, all);
    backend->complete(view, all);
    SeenSurface seen;
    const Extent rows{0, 20, 101, 90};
    backend->see(rows, seen);
    EXPECT_EQ(seen.rows(), rows);
    EXPECT_NEAR(seen.depth(view, 50, 50), 5 - 1, 1e-3);  // The sphere's radius is 1.
    EXPECT_GT(glm::dot(seen.normal(view, 50, 50), -view.forward), 0.999f);
    EXPECT_FALSE(seen.covered(0, 50));
    EXPECT_FALSE(seen.step(0, 50).has_value());
    int right = 100;
    while (!seen.covered(right, 50)) --right;
    right = 50 + (right - 50) / 2;  // Half way to the edge: turned to the right.
    EXPECT_GT(glm::dot(seen.normal(view, right, 50), view.right), 0.4f);
    EXPECT_NEAR(glm::dot(seen.normal(view, right, 50), view.up), 0, 0.05f);
    ASSERT_TRUE(seen.step(right, 50).has_value());
    const glm::vec2 step = *seen.step(right, 50);
    EXPECT_GT(std::abs(step.y), 0.5f);
    EXPECT_LT(std::abs(step.x), 0.1f * std::abs(step.y));
}

}  // namespace
}  // namespace aeolic
