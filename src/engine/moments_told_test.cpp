#include "engine/testing/moments_testing.h"

/// Which moment is shown is told truly: by the renderer, in the picture, and in warnings.
namespace aeolic {
namespace {

using namespace test;

TEST_F(Moments, OutsideTheStepsIsTheNearestEnd)
{
    Renderer renderer(files());
    renderer.setTime(-7);
    EXPECT_EQ(renderer.render({}).pixels, at(files(), 0).pixels);
    renderer.setTime(7);
    EXPECT_EQ(renderer.render({}).pixels, at(files(), 2).pixels);
}

TEST_F(Moments, TheMomentToldIsTheOneShown)
{
    SceneDescription d = files();
    d.time.moment = 99;
    Renderer renderer(d);
    EXPECT_EQ(renderer.info().time, 2);
    renderer.setTime(-7);
    EXPECT_EQ(renderer.info().time, 0);
    renderer.render({});
    EXPECT_EQ(renderer.lastFrame().time, 0);
    Renderer endless(builtIn());
    endless.setTime(99);
    EXPECT_EQ(endless.info().time, 99) << "built-in data have every moment";
}

TEST_F(Moments, TheTimeStampIsOfTheMomentShown)
{
    SceneDescription d = files();
    d.shading.scalarBar = false;
    d.output.width = d.output.height = 300;
    const Picture bare = at(d, 2);
    d.shading.timeStamp = true;
    const Picture end = at(d, 2);
    EXPECT_NE(end.pixels, bare.pixels);
    EXPECT_EQ(at(d, 99).pixels, end.pixels);
    d.output.frames = 3;
    d.time.range = {1.0, 5.0};
    Renderer renderer(d);
    EXPECT_NE(renderer.render({AnimationFrame{0}}).pixels, end.pixels);
    EXPECT_EQ(renderer.render({AnimationFrame{1}}).pixels, end.pixels);
    EXPECT_EQ(renderer.render({AnimationFrame{2}}).pixels, end.pixels);
}

TEST_F(Moments, AMomentOutsideOfTheDataIsWarnedOf)
{
    using Lines = std::vector<std::string>;
    const std::string outside = ": the data have moments from 0 to 2; outside of them the nearest one is shown";
    SceneDescription d = files();
    d.shading.scalarBar = false;  // So small a picture has no room for it.
    Renderer renderer(d);
    EXPECT_EQ(renderer.info().warnings, Lines{});
    renderer.setTime(2.5);
    EXPECT_EQ(renderer.info().warnings, Lines{"--time 2.5" + outside});
    EXPECT_EQ(renderer.info().dataWarnings, 1u);
    renderer.setTime(2);
    EXPECT_EQ(renderer.info().warnings, Lines{});
    d.time.range = {0.0, 5.0};
    EXPECT_EQ(Renderer(d).info().warnings, Lines{}) << "only its first moment is shown";
    d.output.frames = 3;
    Renderer animation(d);
    for (int frame = 0; frame < 3; ++frame) {
        animation.render({AnimationFrame{frame}});
        EXPECT_EQ(animation.info().warnings, Lines{"--time-range 0,5" + outside});
    }
    // `aeolic info` writes moments with six digits.
    d = files();
    d.shading.scalarBar = false;
    d.time.moment = 2.00001;
    EXPECT_EQ(Renderer(d).info().warnings, Lines{});
    SceneDescription endless = builtIn();
    endless.shading.scalarBar = false;
    endless.time.moment = 99;
    EXPECT_EQ(Renderer(endless).info().warnings, Lines{});
}

}  // namespace
}  // namespace aeolic
