#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "cluster/comm/communicator.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

SceneDescription described()
{
    SceneDescription scene;
    scene.surface.spec = "torus:2000";
    scene.field.spec = "gyre:9,9,9";
    scene.lic.steps = 12;
    scene.camera.azimuth = 70;
    scene.output.width = 90;
    scene.output.height = 70;
    scene.run.backend = BackendChoice::cpu;
    return scene;
}

TEST(FrameSpec, OneThatSaysNothingIsThePictureThatIsDescribed)
{
    const SceneDescription still = described();
    Renderer renderer(still);
    const DrawnFrame picture = renderer.render();
    EXPECT_EQ(picture.pixels, renderer.render({still.camera}).pixels);
    EXPECT_NE(picture.pixels, renderer.render({CameraOptions{}}).pixels);
    EXPECT_EQ(picture.width, 90);
    EXPECT_EQ(picture.height, 70);
    EXPECT_EQ(picture.firstRow, 0);
    EXPECT_EQ(picture.wholeHeight, 70);
    EXPECT_FALSE(picture.legend);

    SceneDescription moving = still;
    moving.output.frames = 3;
    moving.output.orbit = 90;
    moving.time.range = {1, 4};
    Renderer animation(moving);
    EXPECT_EQ(animation.render().pixels, animation.render({AnimationFrame{0}}).pixels);
    EXPECT_EQ(animation.lastFrame().time, 1);
}

/// What setTime() has set is shown by all but the frames of a range.
TEST(FrameSpec, AStillShowsTheMomentThatWasSet)
{
    Renderer renderer(described());
    const Picture first = renderer.render();
    renderer.setTime(2);
    const Picture later = renderer.render();
    EXPECT_NE(later.pixels, first.pixels);
    EXPECT_EQ(later.pixels, renderer.render({described().camera}).pixels);
}

/// Any frame can be left where it was drawn: an animation's, too.
TEST(FrameSpec, RowsThatAreNotGatheredAreThoseOfThePicture)
{
    SceneDescription scene = described();
    scene.output.frames = 4;
    scene.shading.colorBy = "gyre:mag";
    scene.run.threads = 1;
    const DrawnFrame whole = Renderer(scene).render({AnimationFrame{2}});
    std::vector<DrawnFrame> rows(3);
    runRanks(3, [&](Communicator& ranks) {
        Renderer renderer(scene, std::shared_ptr<Communicator>(&ranks, [](Communicator*) {}));
        rows[std::size_t(ranks.rank())] = renderer.render({AnimationFrame{2}, false});
        const DrawnFrame gathered = renderer.render({AnimationFrame{2}});
        EXPECT_EQ(gathered.pixels.empty(), !ranks.isRoot());
    });
    int row = 0;
    for (const DrawnFrame& part : rows) {
        EXPECT_EQ(part.firstRow, row);
        EXPECT_EQ(part.wholeHeight, whole.height);
        EXPECT_EQ(part.legend, whole.legend);
        const auto begin = whole.pixels.begin() + std::ptrdiff_t(3) * whole.width * row;
        EXPECT_TRUE(std::equal(part.pixels.begin(), part.pixels.end(), begin)) << row;
        row += part.height;
    }
    EXPECT_EQ(row, whole.height);
}

/// Frames of both kinds follow each other, and each comes as it was asked for.
TEST(FrameSpec, FinishGivesWhatWasStarted)
{
    const SceneDescription scene = described();
    Renderer renderer(scene);
    const Picture whole = renderer.render();
    Picture kept = renderer.render({scene.camera, false});
    EXPECT_EQ(kept.pixels, whole.pixels) << "one rank has all rows";
    const std::uint8_t* const memory = kept.pixels.data();
    renderer.start();
    const DrawnFrame again = renderer.finish(std::move(kept));
    EXPECT_EQ(again.pixels, whole.pixels);
    EXPECT_EQ(again.pixels.data(), memory) << "its memory is used again";
    EXPECT_THROW(renderer.finish(), std::logic_error);
}

TEST(FrameSpec, FramesThatThereAreNotAreRefused)
{
    SceneDescription scene = described();
    scene.output.frames = 2;
    Renderer renderer(scene);
    for (const int index : {-1, 2}) EXPECT_THROW(renderer.start({AnimationFrame{index}}), InputError) << index;
    CameraOptions camera;
    camera.zoom = 0;
    EXPECT_THROW(renderer.start({camera}), InputError);
    EXPECT_THROW(renderer.finish(), std::logic_error) << "nothing was started";
}

}  // namespace
}  // namespace aeolic
