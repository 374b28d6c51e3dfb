#include "engine/picture_buffers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "aeolic/renderer.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

SceneDescription picturesOf(BackendChoice backend)
{
    SceneDescription scene;
    scene.surface.spec = "torus:3000";
    scene.field.spec = "rotation:17,17,17";
    scene.shading.colorBy = "rotation:mag";
    scene.shading.antialias = false;
    scene.shading.background = "transparent";
    scene.output.width = 90;
    scene.output.height = 70;
    scene.lic.steps = 8;
    scene.run.backend = backend;
    return scene;
}

bool isUntold(float value)
{
    return std::isnan(value);
}

/// Whether the lists are equal, where NaN counts as equal to NaN.
bool sameNumbers(const std::vector<float>& a, const std::vector<float>& b)
{
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
               return x == y || (std::isnan(x) && std::isnan(y));
           });
}

TEST(PictureBuffers, TellWhatPickTellsOfEachPixel)
{
    const SceneDescription scene = picturesOf(BackendChoice::cpu);
    Renderer renderer(scene);
    const PictureBuffers all = renderer.buffers();
    const Picture picture = renderer.render();
    ASSERT_EQ(all.width, 90);
    ASSERT_EQ(all.height, 70);
    ASSERT_EQ(all.depth.size(), 6300u);
    ASSERT_EQ(all.normal.size(), 3 * 6300u);
    ASSERT_EQ(all.flow.size(), 2 * 6300u);
    ASSERT_EQ(all.lic.size(), 6300u);
    ASSERT_EQ(all.scalar.size(), 6300u);
    int compared = 0, far = 0;
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < 6300; ++i) {
        ASSERT_EQ(isUntold(all.depth[i]), picture.pixels[4 * i + 3] == 0) << i;
        ASSERT_EQ(isUntold(all.depth[i]), isUntold(all.normal[3 * i]));
        ASSERT_EQ(isUntold(all.flow[2 * i]), isUntold(all.lic[i]));
        if (isUntold(all.depth[i])) continue;
        if (!isUntold(all.lic[i])) sum += double(all.lic[i]), squares += double(all.lic[i] * all.lic[i]);
        if (i % 7 != 0) continue;
        const auto place = renderer.pick(int(i % 90), int(i / 90));
        if (!place) continue;
        ++compared;
        far += std::abs(place->depth - double(all.depth[i])) > 1e-3 * place->depth;
        far += std::abs(*place->scalar - double(all.scalar[i])) > 1e-2;
        double cosine = 0;
        for (std::size_t c = 0; c < 3; ++c) cosine += place->normal[c] * double(all.normal[3 * i + c]);
        far += cosine < 0.99;
        // A step is one pixel long where the surface is turned to the eye, and shorter elsewhere.
        far += !isUntold(all.flow[2 * i]) && !(std::hypot(all.flow[2 * i], all.flow[2 * i + 1]) < 1.8f);
    }
    EXPECT_GT(compared, 200);
    EXPECT_LE(far, compared / 25) << "edges of triangles lie between pixels";
    EXPECT_NEAR(sum / (7 * compared), 0, 0.3);
    EXPECT_NEAR(squares / (7 * compared), 1, 0.6);
}

TEST(PictureBuffers, AreThoseOfAnyRanks)
{
    const SceneDescription scene = picturesOf(BackendChoice::cpu);
    const PictureBuffers alone = Renderer(scene).buffers();
    for (const int ranks : {2, 3}) {
        runRanks(ranks, [&](Communicator& group) {
            Renderer renderer(scene, std::shared_ptr<Communicator>(&group, [](Communicator*) {}));
            CameraOptions turned;
            turned.azimuth = 70;
            const PictureBuffers other = renderer.buffers(turned), all = renderer.buffers();
            if (!group.isRoot()) {
                EXPECT_EQ(all.width, 0);
                EXPECT_TRUE(all.depth.empty());
                return;
            }
            EXPECT_FALSE(sameNumbers(other.depth, alone.depth));
            EXPECT_EQ(all.height, alone.height);
            EXPECT_TRUE(sameNumbers(all.depth, alone.depth));
            EXPECT_TRUE(sameNumbers(all.normal, alone.normal));
            EXPECT_TRUE(sameNumbers(all.flow, alone.flow));
            EXPECT_TRUE(sameNumbers(all.lic, alone.lic));
            EXPECT_TRUE(sameNumbers(all.scalar, alone.scalar));
            EXPECT_EQ(all.surface, alone.surface);
        });
    }
}

/// Two bodies that run through each other, one of them twice, and one inside that nobody sees.
SceneDescription bodies(BackendChoice backend)
{
    SceneDescription scene = picturesOf(backend);
    for (const char* spec : {"sphere:2000", "torus:3000", "sphere:2000", "sphere:20"}) {
        SurfaceItem item;
        item.spec = spec;
        scene.surfaces.push_back(item);
    }
    scene.camera.azimuth = 40;
    scene.camera.zoom = 1.4;
    return scene;
}

TEST(PictureBuffers, TellWhichSurfaceThatIs)
{
    Renderer renderer(bodies(BackendChoice::cpu));
    const PictureBuffers all = renderer.buffers();
    ASSERT_EQ(all.surface.size(), 6300u);
    std::array<int, 4> count{};
    int compared = 0, other = 0;
    for (std::size_t i = 0; i < 6300; ++i) {
        ASSERT_EQ(all.surface[i] == -1, isUntold(all.depth[i])) << i;
        if (all.surface[i] < 0) continue;
        ASSERT_LT(all.surface[i], 4);
        ++count[std::size_t(all.surface[i])];
        const auto place = i % 5 == 0 ? renderer.pick(int(i % 90), int(i / 90)) : std::nullopt;
        if (!place) continue;
        ++compared;
        other += place->surface != (all.surface[i] == 1 ? "torus:3000" : "sphere:2000");
    }
    EXPECT_GT(count[0], 300);
    EXPECT_GT(count[1], 300);
    EXPECT_EQ(count[2], 0) << "the first in the same place shows";
    EXPECT_EQ(count[3], 0);
    EXPECT_GT(compared, 200);
    EXPECT_LE(other, 2) << "the line where they meet lies between pixels";
    renderer.setShown({false, true, true, true});
    const PictureBuffers without = renderer.buffers();
    EXPECT_EQ(std::count(without.surface.begin(), without.surface.end(), 0), 0);
    EXPECT_EQ(std::count(without.surface.begin(), without.surface.end(), 2), count[0]);
}

TEST(PictureBuffers, TellSurfacesFromWithinAndByAnyRanks)
{
    SceneDescription scene = bodies(BackendChoice::cpu);
    // From afar, and from a place within the bodies: some triangles lie behind the eye, and some reach there.
    for (const bool within : {false, true}) {
        if (within) {
            scene.surfaces[1].spec = "torus:300";
            scene.camera.position = Vec3{0.1, 0.2, 0.05};
            scene.camera.focal = Vec3{1, 0.3, 0.1};
        }
        const PictureBuffers alone = Renderer(scene).buffers();
        std::array<int, 4> count{};
        for (std::size_t i = 0; i < 6300; ++i) {
            ASSERT_EQ(alone.surface[i] == -1, isUntold(alone.depth[i])) << within << " " << i;
            if (alone.surface[i] >= 0) ++count[std::size_t(alone.surface[i])];
        }
        EXPECT_GT(count[0] + count[1], 1000) << within;
        runRanks(3, [&](Communicator& group) {
            Renderer renderer(scene, std::shared_ptr<Communicator>(&group, [](Communicator*) {}));
            const PictureBuffers all = renderer.buffers();
            EXPECT_TRUE(!group.isRoot() || all.surface == alone.surface) << within;
        });
    }
}

TEST(PictureBuffers, OfAPlainSurfaceHaveNoFlowAndNoScalar)
{
    SceneDescription scene = picturesOf(BackendChoice::cpu);
    SurfaceItem plain;
    plain.spec = "torus:3000";
    plain.streaks = false;
    SurfaceItem beside;
    beside.spec = "sphere:500";
    scene.surfaces = {plain, beside};
    scene.shading.colorBy.clear();
    Renderer renderer(scene);
    renderer.setShown({true, false});
    const PictureBuffers all = renderer.buffers();
    EXPECT_TRUE(all.scalar.empty());
    EXPECT_TRUE(std::any_of(all.depth.begin(), all.depth.end(), [](float depth) { return !isUntold(depth); }));
    for (const float step : all.flow) ASSERT_TRUE(isUntold(step));
    for (const float lic : all.lic) ASSERT_TRUE(isUntold(lic));
}

TEST(PictureBuffers, WaitForFramesThatAreStarted)
{
    Renderer renderer(picturesOf(BackendChoice::cpu));
    renderer.start();
    EXPECT_THROW(renderer.buffers(), std::logic_error);
    renderer.finish();
    EXPECT_NO_THROW(renderer.buffers());
}

}  // namespace
}  // namespace aeolic
