#include "engine/scene_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "cluster/comm/communicator.h"
#include "description/choices.h"
#include "ranks/thread_communicator.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

class SceneOverlays : public BackendTest {
protected:
    SceneDescription described(const std::string& surface = "torus:4000", const std::string& field = "abc:32,32,32")
    {
        SceneDescription scene;
        scene.surface.spec = surface;
        scene.field.spec = field;
        scene.lic.steps = 8;
        scene.output.width = 160;
        scene.output.height = 130;
        scene.shading.overlay = "topology";
        scene.run.backend = *choiceNamed<BackendChoice>(GetParam());
        return scene;
    }
};
INSTANTIATE_TEST_SUITE_P(Backends, SceneOverlays, allBackends, backendName);

TEST_P(SceneOverlays, TheSameBytesFromAnyNumberOfRanksAndThreads)
{
    SceneDescription scene = described();
    scene.shading.overlay = "edges,outline,streamlines:10,topology,separation,through:0.3:-0.9:0.1";
    const Picture alone = Renderer(scene).render();
    for (const int count : {2, 3}) {
        runRanks(count, [&](Communicator& ranks) {
            Renderer renderer(scene, std::shared_ptr<Communicator>(&ranks, [](Communicator*) {}));
            const Picture together = renderer.render();
            EXPECT_EQ(together.pixels, ranks.isRoot() ? alone.pixels : Picture{}.pixels) << count;
        });
    }
    scene.run.threads = 1;
    EXPECT_EQ(Renderer(scene).render().pixels, alone.pixels);
}

/// It comes and goes with the option, and only changes pixels near its lines.
TEST_P(SceneOverlays, IsDrawnOverThePicture)
{
    SceneDescription scene = described();
    Renderer renderer(scene);
    const Picture with = renderer.render();
    ShadingOptions shading = scene.shading;
    shading.overlay = "none";
    renderer.setShading(shading);
    const Picture without = renderer.render();
    scene.shading.overlay = "none";
    EXPECT_EQ(without.pixels, Renderer(scene).render().pixels);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) changed += with.pixels[i] != without.pixels[i];
    EXPECT_GT(changed, with.pixels.size() / 200);
    EXPECT_LT(changed, with.pixels.size() / 3);
    shading.overlay = "topology";
    renderer.setShading(shading);
    EXPECT_EQ(renderer.render().pixels, with.pixels);
}

TEST_P(SceneOverlays, EachPaintsWhatTheOthersDoNot)
{
    SceneDescription scene = described("sphere:500", "abc:16,16,16");
    std::set<std::vector<std::uint8_t>> pictures;
    for (const char* overlay : {"none", "edges", "outline", "streamlines", "streamlines:60", "topology", "separation",
                                "streamlines,outline", "edges,outline", "through:0:-1:0.2", "through:0:-1:0.6"}) {
        scene.shading.overlay = overlay;
        EXPECT_TRUE(pictures.insert(Renderer(scene).render().pixels).second) << overlay;
    }
}

/// The circle around the axis through the point that is asked for, seen from the side: a row of the picture.
TEST_P(SceneOverlays, TheStreamlineThroughAPlace)
{
    SceneDescription scene = described("sphere:20000", "rotation:33,33,33");
    scene.lic.method = LicMethod::none;
    scene.output.width = scene.output.height = 201;
    scene.camera.position = Vec3{0, -10, 0};
    scene.camera.focal = Vec3{0, 0, 0};
    scene.camera.up = Vec3{0, 0, 1};
    scene.shading.overlay = "none";
    const Picture without = Renderer(scene).render();
    scene.shading.overlay = "through:0.1:-3:0";
    const Picture with = Renderer(scene).render();
    std::size_t changed = 0, far = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        if (with.pixels[i] == without.pixels[i]) continue;
        ++changed;
        far += std::abs(int(i / (3 * 201)) - 100) > 12;
    }
    EXPECT_GT(changed, 500u);
    EXPECT_EQ(far, 0u);
}

/// Which levels of streamlines there are depends on what was looked at before; a picture does not.
TEST_P(SceneOverlays, StreamlinesDoNotDependOnTheViewBefore)
{
    SceneDescription scene = described("torus:4000", "rotation:16,16,16");
    scene.shading.overlay = "streamlines";
    Renderer renderer(scene);
    const Picture first = renderer.render();
    CameraOptions near;
    near.zoom = 12;
    const Picture closeUp = renderer.render({near});
    EXPECT_EQ(renderer.render().pixels, first.pixels);
    scene.camera = near;
    EXPECT_EQ(Renderer(scene).render().pixels, closeUp.pixels);
}

/// Where lines are on the surface does not depend on the view.
TEST_P(SceneOverlays, StreamlinesStayOnTheSurface)
{
    SceneDescription scene = described("plane:2000", "uniform:16,16,16");  // Along x.
    scene.output.width = scene.output.height = 300;
    scene.shading.overlay = "streamlines:60";
    scene.shading.lighting = false;
    scene.lic.method = LicMethod::none;
    Renderer renderer(scene);
    const auto heightsOfLines = [&](double azimuth, double elevation) {
        CameraOptions camera;
        camera.azimuth = azimuth;
        camera.elevation = elevation;
        const Picture picture = renderer.render({camera});
        std::vector<double> heights;
        for (int y = 0; y < 300; y += 2)
            for (int x = 0; x < 300; x += 2)
                if (picture.pixels[std::size_t(3 * (300 * y + x))] < 60)
                    if (const auto place = renderer.pick(x, y, camera)) heights.push_back(place->position[1]);
        return heights;
    };
    const std::vector<double> before = heightsOfLines(0, 80);
    ASSERT_GT(before.size(), 50u);
    std::size_t beside = 0, all = 0;
    for (const double height : heightsOfLines(25, 65)) {
        const bool isThere =
            std::any_of(before.begin(), before.end(), [&](double other) { return std::abs(other - height) < 0.03; });
        ++all;
        beside += isThere ? 0 : 1;
    }
    EXPECT_GT(all, 50u);
    EXPECT_LT(double(beside), 0.2 * double(all));  // Heads, and lines of the next level.
}

TEST_P(SceneOverlays, StreamlinesComeAndGoWithoutAJump)
{
    SceneDescription scene = described("plane:2000", "uniform:16,16,16");
    scene.shading.overlay = "streamlines";
    scene.shading.lighting = false;
    scene.lic.method = LicMethod::none;
    scene.camera.azimuth = 0;
    scene.camera.elevation = 90;
    Renderer renderer(scene);
    const auto ink = [&](double zoom) {
        CameraOptions camera = scene.camera;
        camera.zoom = zoom;
        const Picture picture = renderer.render({camera});
        double sum = 0;
        for (const std::uint8_t value : picture.pixels) sum += 255 - value;
        return sum / double(picture.pixels.size());
    };
    // Coming nearer by a hundredth never changes how much is drawn by a jump.
    double last = ink(1.5);
    for (double zoom = 1.515; zoom < 3.2; zoom *= 1.01) {
        const double now = ink(zoom);
        EXPECT_NEAR(now, last, 0.08 * last) << zoom;
        last = now;
    }
}

/// A flow that turns around the torus' axis has no critical point, however many the mesh has.
TEST_P(SceneOverlays, WhereThereIsNothingThePictureStays)
{
    SceneDescription scene = described("torus:4000", "rotation:32,32,32");
    const Picture with = Renderer(scene).render();
    scene.shading.overlay = "none";
    EXPECT_EQ(with.pixels, Renderer(scene).render().pixels);
}

TEST_P(SceneOverlays, FollowsTheMomentAndTheOption)
{
    SceneDescription scene = described("sphere:2000", "gyre:17,17,17");
    scene.lic.method = LicMethod::none;
    Renderer renderer(scene);
    const Picture first = renderer.render();
    renderer.setTime(3);
    const Picture later = renderer.render();
    scene.time.moment = 3;
    EXPECT_EQ(later.pixels, Renderer(scene).render().pixels);
    EXPECT_NE(later.pixels, first.pixels);

    ShadingOptions shading = scene.shading;
    shading.persistence = 1;
    renderer.setShading(shading);
    scene.shading.persistence = 1;
    EXPECT_EQ(renderer.render().pixels, Renderer(scene).render().pixels);
}

TEST_P(SceneOverlays, TheMarkOfAPoleIsWhereThePoleIs)
{
    SceneDescription scene = described("sphere:20000", "uniform:9,9,9");  // Along x.
    scene.lic.method = LicMethod::none;
    scene.output.width = scene.output.height = 101;
    scene.camera.position = Vec3{10, 0, 0};
    scene.camera.focal = Vec3{0, 0, 0};
    scene.camera.up = Vec3{0, 0, 1};
    const Picture with = Renderer(scene).render();
    scene.shading.overlay = "none";
    const Picture without = Renderer(scene).render();
    int least = 101, most = 0;
    for (int y = 0; y < 101; ++y)
        for (int x = 0; x < 101; ++x) {
            const auto at = std::size_t(3 * (101 * y + x));
            if (std::equal(&with.pixels[at], &with.pixels[at] + 3, &without.pixels[at])) continue;
            least = std::min({least, x, y});
            most = std::max({most, x, y});
        }
    EXPECT_NEAR(0.5 * (least + most), 50, 1.5);
    EXPECT_LE(most - least, 14);
}

SceneDescription sphereAlongX()
{
    SceneDescription scene;
    scene.surface.spec = "sphere:20000";
    scene.field.spec = "uniform:9,9,9";
    scene.shading.colorBy = "uniform:mag";
    scene.run.backend = BackendChoice::cpu;
    scene.output.width = scene.output.height = 32;
    return scene;
}

TEST(FlowTopology, TellsWhatTheSurfaceHasAtThePoints)
{
    const FlowTopology topology = Renderer(sphereAlongX()).topology();
    ASSERT_EQ(topology.points.size(), 2u);
    EXPECT_TRUE(topology.lines.empty());
    EXPECT_EQ(topology.scalar, "|uniform|");
    for (const FlowPoint& point : topology.points) {
        EXPECT_EQ(point.kind, CriticalPointKind::node);
        EXPECT_EQ(point.index, 1);
        EXPECT_NEAR(point.at.position[0], point.attracts ? 1 : -1, 1e-3);
        EXPECT_NEAR(point.at.vector[0], point.at.scalar, 1e-6);
        EXPECT_NEAR(point.at.vector[1], 0, 1e-6);
    }
}

TEST(FlowTopology, TheSameOnAllRanksAndByThePersistenceAskedFor)
{
    SceneDescription scene = sphereAlongX();
    scene.surface.spec = "torus:4000";
    scene.field.spec = "abc:32,32,32";
    scene.shading.colorBy = "";
    scene.shading.persistence = 0;
    const FlowTopology alone = Renderer(scene).topology();
    ASSERT_FALSE(alone.lines.empty());
    int sum = 0;
    for (const FlowPoint& point : alone.points) sum += point.index;
    EXPECT_EQ(sum, 0) << "the Euler characteristic";
    for (const FlowLine& line : alone.lines) {
        EXPECT_EQ(alone.points[*line.saddle].index, -1);
        EXPECT_EQ(line.places.front().position, alone.points[*line.saddle].at.position);
    }
    runRanks(2, [&](Communicator& ranks) {
        Renderer renderer(scene, std::shared_ptr<Communicator>(&ranks, [](Communicator*) {}));
        const FlowTopology one = renderer.topology();
        ASSERT_EQ(one.points.size(), alone.points.size());
        ASSERT_EQ(one.lines.size(), alone.lines.size());
        for (std::size_t i = 0; i < one.lines.size(); ++i) EXPECT_EQ(one.lines[i].length, alone.lines[i].length);
    });
    scene.shading.persistence = 1;
    EXPECT_LT(Renderer(scene).topology().points.size(), alone.points.size());
}

}  // namespace
}  // namespace aeolic
