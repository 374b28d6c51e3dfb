#include "engine/scene_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "aeolic/renderer.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

TEST(TimeStamp, KeepsItsDigitsThroughAnAnimation)
{
    EXPECT_EQ(timeStampOf(0.5, {0, 1}), "t = 0.500");
    EXPECT_EQ(timeStampOf(1, {0, 0.5, 1}), "t = 1.000");
    EXPECT_EQ(timeStampOf(12, {0, 2000}), "t = 12");
    EXPECT_EQ(timeStampOf(-3, {-10, 10}), "t = -3.0");
    EXPECT_EQ(timeStampOf(0.0123, {0, 0.02}), "t = 0.0123");
    EXPECT_EQ(timeStampOf(3, {3, 3}), "t = 3");
    EXPECT_EQ(timeStampOf(1e9, {1e9, 2e9}), "t = 1e+09");
}

/// A coloured square that fills the upper right of the picture alone.
SceneDescription upperRight()
{
    SceneDescription scene;
    scene.surface.spec = "plane";
    scene.field.spec = "uniform:2,2,2";
    scene.shading.colorBy = "uniform:mag";
    scene.lic.method = LicMethod::none;
    scene.output.width = scene.output.height = 400;
    scene.run.backend = BackendChoice::cpu;
    scene.camera.position = Vec3{0, 0, 4};
    scene.camera.focal = Vec3{-0.8, -0.8, 0};
    scene.camera.up = Vec3{0, 1, 0};
    return scene;
}

/// Ranks that each draw their own rows find the same corner for the legend.
TEST(SceneFigure, StripesAreTheRowsOfTheWholePicture)
{
    SceneDescription scene = upperRight();
    scene.shading.title = "A title";
    scene.shading.axes = true;
    const Picture whole = Renderer(scene).render(scene.camera);
    scene.run.threads = 1;
    runRanks(3, [&](Communicator& communicator) {
        Renderer one(scene, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const PictureStripe stripe = one.renderStripe(scene.camera);
        const std::size_t rowBytes = 3 * 400;
        EXPECT_TRUE(std::equal(stripe.rows.pixels.begin(), stripe.rows.pixels.end(),
                               whole.pixels.begin() + std::ptrdiff_t(rowBytes) * stripe.firstRow));
    });
}

/// The legend stays where it is in an animation, and moves out of the surface's way in a still.
TEST(SceneFigure, TheLegendMovesInAStillAlone)
{
    SceneDescription scene = upperRight();
    const auto darkIn = [](const Picture& picture, bool right, bool upper) {
        int dark = 0;
        for (int y = upper ? 0 : 200; y < (upper ? 200 : 400); ++y)
            for (int x = right ? 200 : 0; x < (right ? 400 : 200); ++x) {
                const std::uint8_t* pixel = &picture.pixels[std::size_t(3 * (400 * y + x))];
                dark += pixel[0] == 26 && pixel[1] == 26 && pixel[2] == 26;
            }
        return dark;
    };
    Renderer still(scene);
    const Picture moved = still.render(scene.camera);
    EXPECT_EQ(darkIn(moved, true, true), 0) << "the surface is there";
    EXPECT_GT(darkIn(moved, true, false) + darkIn(moved, false, true) + darkIn(moved, false, false), 100);
    scene.output.frames = 2;
    Renderer animation(scene);
    EXPECT_GT(darkIn(animation.renderFrame(0), true, true), 100);
}

}  // namespace
}  // namespace aeolic
