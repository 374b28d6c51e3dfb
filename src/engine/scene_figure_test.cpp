#include "engine/scene_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"
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

/// A legend of its own tells which vectors have streaks in full, beside that of the colours.
TEST(SceneFigure, StreaksThatFadeHaveALegend)
{
    SceneDescription scene = upperRight();
    scene.shading.colorBy = "";
    scene.lic.method = LicMethod::direct;
    scene.lic.steps = 4;
    const auto legendOf = [&] { return Renderer(scene).render({scene.camera}).legend; };
    EXPECT_FALSE(legendOf());
    for (const Magnitude magnitude : {Magnitude::contrast, Magnitude::length}) {
        scene.lic.magnitude = magnitude;
        EXPECT_TRUE(legendOf());
    }
    const auto alone = legendOf();
    scene.shading.colorBy = "uniform:mag";
    const auto both = legendOf();
    ASSERT_TRUE(alone && both);
    EXPECT_GT((*both)[2], (*alone)[2]);
    scene.lic.method = LicMethod::none;
    scene.shading.colorBy = "";
    EXPECT_FALSE(legendOf());
    scene.lic.method = LicMethod::direct;
    scene.shading.scalarBar = false;
    EXPECT_FALSE(legendOf());
}

/// Ranks that each draw their own rows find the same corner for the legend.
TEST(SceneFigure, StripesAreTheRowsOfTheWholePicture)
{
    SceneDescription scene = upperRight();
    scene.shading.title = "A title";
    scene.shading.axes = true;
    const DrawnFrame whole = Renderer(scene).render({scene.camera});
    scene.run.threads = 1;
    runRanks(3, [&](Communicator& communicator) {
        Renderer one(scene, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const DrawnFrame stripe = one.render({scene.camera, false});
        const std::size_t rowBytes = 3 * 400;
        EXPECT_TRUE(std::equal(stripe.pixels.begin(), stripe.pixels.end(),
                               whole.pixels.begin() + std::ptrdiff_t(rowBytes) * stripe.firstRow));
        EXPECT_EQ(stripe.wholeHeight, whole.height);
        ASSERT_TRUE(stripe.legend);
        EXPECT_EQ(stripe.legend, whole.legend);
        const auto [x, y, width, height] = *stripe.legend;
        EXPECT_LT(x + width, 200) << "all know that it is in the upper left";
        EXPECT_LT(y, 100);
        EXPECT_GT(std::min(width, height), 20);
    });
}

TEST(SceneFigure, AStripeWithoutALegendTellsOfNone)
{
    SceneDescription scene = upperRight();
    scene.shading.scalarBar = false;
    EXPECT_FALSE(Renderer(scene).render({scene.camera, false}).legend);
}

/// Which quarters of the picture hold the legend's ink.
struct Quarters {
    bool upperRight = false, lowerRight = false, upperLeft = false, lowerLeft = false;
    bool operator==(const Quarters&) const = default;
};

Quarters inkIn(const Picture& picture)
{
    const auto dark = [&](bool right, bool lower) {
        const int w = picture.width / 2, h = picture.height / 2;
        int count = 0;
        for (int y = lower ? h : 0; y < (lower ? 2 * h : h); ++y)
            for (int x = right ? w : 0; x < (right ? 2 * w : w); ++x) {
                const std::uint8_t* pixel = &picture.pixels[std::size_t(3 * (picture.width * y + x))];
                count += pixel[0] == 26 && pixel[1] == 26 && pixel[2] == 26;
            }
        return count > 100;
    };
    return {dark(true, false), dark(true, true), dark(false, false), dark(false, true)};
}

TEST(SceneFigure, TheLegendOfAStillMovesOutOfTheSurfacesWay)
{
    const SceneDescription scene = upperRight();
    EXPECT_EQ(inkIn(Renderer(scene).render({scene.camera})), (Quarters{.upperLeft = true}));
}

/// Half a turn brings the surface into the upper left: only the lower corners are nearly free in both pictures.
TEST(SceneFigure, TheLegendOfAnAnimationStaysWhereTheSurfaceIsLeast)
{
    SceneDescription scene = upperRight();
    scene.output.frames = 2;
    Renderer animation(scene);
    const Quarters first = inkIn(animation.render({AnimationFrame{0}})),
                   second = inkIn(animation.render({AnimationFrame{1}}));
    EXPECT_TRUE(first.lowerRight || first.lowerLeft);
    EXPECT_FALSE(first.upperRight || first.upperLeft);
    EXPECT_EQ(first, second);
}

/// All corners are covered, but stripes at the left and below are free.
TEST(SceneFigure, WithoutAFreeCornerTheLegendTakesTheOneThatIsCoveredLeast)
{
    SceneDescription scene = upperRight();
    scene.camera.position = Vec3{-0.3, -0.3, 3.2};
    scene.camera.focal = Vec3{-0.3, -0.3, 0};
    scene.output.frames = 3;
    scene.output.orbit = 3;
    EXPECT_EQ(inkIn(Renderer(scene).render({AnimationFrame{0}})), (Quarters{.lowerLeft = true}));
}

/// A program that draws a part of the frames, in whatever order, or with other ranks, finds the same corner.
TEST(SceneFigure, TheLegendsCornerIsTheSameWhicheverFrameIsDrawnFirst)
{
    for (const char* surface : {"wave:2000", "teapot:2000"}) {
        SceneDescription scene = upperRight();
        scene.surface.spec = surface;
        scene.field.spec = "abc:8,8,8";
        scene.shading.colorBy = "abc:mag";
        scene.camera = {};
        scene.output.frames = 5;
        if (surface[0] == 'w') scene.time.range = {{0, 4}};
        Renderer all(scene);
        std::vector<Picture> pictures;
        pictures.reserve(5);
        for (int frame = 0; frame < 5; ++frame) pictures.push_back(all.render({AnimationFrame{frame}}));
        EXPECT_EQ(Renderer(scene).render({AnimationFrame{3}}).pixels, pictures[3].pixels);
        scene.run.threads = 1;
        runRanks(3, [&](Communicator& communicator) {
            Renderer one(scene, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
            const Picture picture = one.render({AnimationFrame{4}});
            if (communicator.rank() == 0) {
                EXPECT_EQ(picture.pixels, pictures[4].pixels);
            }
        });
    }
}

/// A picture from a camera of its own does not belong to the animation: its legend stands as in a single picture.
TEST(SceneFigure, OnlyFramesOfTheAnimationHaveItsCorner)
{
    SceneDescription scene = upperRight();
    const Picture still = Renderer(scene).render({scene.camera});
    scene.output.frames = 2;
    Renderer renderer(scene);
    EXPECT_NE(renderer.render({AnimationFrame{0}}).pixels, still.pixels);
    EXPECT_EQ(renderer.render({scene.camera}).pixels, still.pixels);
    EXPECT_EQ(renderer.render({scene.camera, false}).pixels, still.pixels);
}

/// A sheet that is in the upper right at first, and in the lower right at last: the first moment counts, also where an
/// option changes when the animation has moved on.
TEST(SceneFigure, TheLegendsCornerGoesByTheFirstMomentAlsoAfterAChange)
{
    const test::TempFolder folder;
    for (int step = 0; step < 3; ++step) {
        test::SheetSample sheet;
        sheet.shift = {0.05, 0.05 - 0.55 * step, 0};
        writeSheetFile(folder.file("s_" + std::to_string(step) + ".vtp"), sheet);
    }
    SceneDescription scene = upperRight();
    scene.surface.spec = folder.file("s_*.vtp");
    scene.field = {};
    scene.field.vectors = "tau";
    scene.shading.colorBy = "q";
    scene.camera.focal = Vec3{0, 0, 0};
    scene.output.frames = 3;
    scene.time.range = {{0, 2}};
    Renderer renderer(scene);
    const Quarters lowerRight{.lowerRight = true};
    EXPECT_EQ(inkIn(renderer.render({AnimationFrame{2}})), lowerRight);
    scene.shading.textScale = 1.1;
    renderer.setShading(scene.shading);
    for (const int frame : {2, 0, 1}) {
        const Picture picture = renderer.render({AnimationFrame{frame}});
        EXPECT_EQ(inkIn(picture), lowerRight) << frame;
        EXPECT_EQ(picture.pixels, Renderer(scene).render({AnimationFrame{frame}}).pixels) << frame;
        EXPECT_EQ(renderer.lastFrame().time, frame);
    }
}

/// A picture that is on its way keeps the legends of what it shows.
TEST(SceneFigure, LegendsAreOfWhatWasShownWhenTheFrameStarted)
{
    SceneDescription scene = upperRight();
    scene.surface = {};
    SurfaceItem plane, sphere;
    plane.spec = "plane";
    sphere.spec = "sphere";
    sphere.colormap = "plasma";
    scene.surfaces = {plane, sphere};
    Renderer renderer(scene);
    const Picture both = renderer.render({scene.camera});
    renderer.start({scene.camera});
    renderer.setShown({true, false});
    EXPECT_EQ(renderer.finish().pixels, both.pixels);
    renderer.start({scene.camera, false});
    renderer.setShown({true, true});
    const Picture one = renderer.finish();
    EXPECT_NE(one.pixels, both.pixels);
    renderer.setShown({true, false});
    EXPECT_EQ(one.pixels, renderer.render({scene.camera}).pixels);
}

/// Other options lay out another legend.
TEST(SceneFigure, AnAnimationsLegendIsPlacedAnewAfterAChange)
{
    SceneDescription scene = upperRight();
    scene.output.frames = 2;
    Renderer renderer(scene);
    renderer.render({AnimationFrame{0}});
    renderer.setSize(300, 200);
    scene.output.width = 300;
    scene.output.height = 200;
    EXPECT_EQ(renderer.render({AnimationFrame{1}}).pixels, Renderer(scene).render({AnimationFrame{1}}).pixels);
}

}  // namespace
}  // namespace aeolic
