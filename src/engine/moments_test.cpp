#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/scene.h"
#include "description/choices.h"
#include "engine/renderer_internals.h"
#include "engine/testing/moments_testing.h"
#include "ranks/thread_communicator.h"

/// A renderer whose scene changes in time: the picture of a moment has the same bytes however it was come by.
namespace aeolic {
namespace {

using namespace test;

TEST_F(Moments, SetTimeGivesTheBytesOfANewRenderer)
{
    for (const SceneDescription& d : {files(), builtIn()}) {
        Renderer renderer(d);
        EXPECT_EQ(renderer.info().time, 0);
        std::vector<std::uint8_t> last;
        for (const double moment : {0.5, 1.75, 0.25, 2.0, 0.0}) {
            renderer.setTime(moment);
            EXPECT_EQ(renderer.info().time, moment);
            const Picture picture = renderer.render({d.camera});
            EXPECT_EQ(picture.pixels, at(d, moment).pixels) << d.surface.spec << " at " << moment;
            EXPECT_NE(picture.pixels, last);
            last = picture.pixels;
            EXPECT_EQ(renderer.lastFrame().time, moment);
        }
    }
}

TEST_F(Moments, FramesRunOverTheRangeOfTime)
{
    SceneDescription d = files();
    d.output.frames = 5;
    d.time.range = {0.0, 2.0};
    d.shading.scalarBar = false;  // In a still it may stand in another corner.
    Renderer renderer(d);
    SceneDescription still = files();
    still.shading.scalarBar = false;
    for (int frame = 0; frame < 5; ++frame)
        EXPECT_EQ(renderer.render({AnimationFrame{frame}}).pixels, at(still, 0.5 * frame).pixels) << frame;
    d.output.orbit = 100;
    Renderer turning(d);
    turning.render({AnimationFrame{0}});
    SceneDescription turned = still;
    turned.camera.azimuth += 40;
    EXPECT_EQ(turning.render({AnimationFrame{2}}).pixels, at(turned, 1).pixels) << "it turns as well where asked to";
    SceneDescription backwards = files();
    backwards.output.frames = 3;
    backwards.shading.scalarBar = false;
    backwards.time.range = {2.0, 1.0};
    Renderer back(backwards);
    EXPECT_EQ(back.render({AnimationFrame{0}}).pixels, at(still, 2).pixels);
    EXPECT_EQ(back.render({AnimationFrame{1}}).pixels, at(still, 1.5).pixels);
}

/// The animation is what was described, before, between and after.
TEST_F(Moments, AMomentLeavesTheAnimationAsItIs)
{
    SceneDescription d = files();
    d.output.frames = 3;
    d.time.range = {0.0, 2.0};
    Renderer untouched(d), renderer(d);
    std::vector<Picture> frames;
    for (int frame = 0; frame < 3; ++frame) frames.push_back(untouched.render({AnimationFrame{frame}}));
    SceneDescription still = files();
    const std::vector<std::uint8_t> half = at(still, 0.5).pixels, later = at(still, 1.25).pixels;
    renderer.setTime(0.5);
    EXPECT_EQ(renderer.render({d.camera}).pixels, half);
    EXPECT_EQ(renderer.render({AnimationFrame{0}}).pixels, frames[0].pixels);
    EXPECT_EQ(renderer.info().time, 0.5) << "what render() shows";
    EXPECT_EQ(renderer.lastFrame().time, 0);
    EXPECT_EQ(renderer.render({d.camera}).pixels, half) << "between two frames";
    renderer.setTime(1.25);
    EXPECT_EQ(renderer.render({AnimationFrame{1}}).pixels, frames[1].pixels);
    EXPECT_EQ(renderer.render({AnimationFrame{2}}).pixels, frames[2].pixels);
    EXPECT_EQ(renderer.render({d.camera}).pixels, later);
    EXPECT_EQ(renderer.description().time.range, d.time.range);
    EXPECT_EQ(renderer.description().time.moment, std::nullopt);
}

/// Whoever waits for other data is not told of an animation's frames: render() shows the same.
TEST_F(Moments, FramesOfAnAnimationAreNoOtherData)
{
    SceneDescription d = files();
    d.output.frames = 3;
    d.time.range = {0.0, 2.0};
    Renderer renderer(d);
    const Picture first = renderer.render({d.camera});
    const std::uint64_t before = RendererInternals::revision(renderer);
    renderer.render({AnimationFrame{2}});
    EXPECT_EQ(RendererInternals::revision(renderer), before);
    EXPECT_EQ(renderer.render({d.camera}).pixels, first.pixels);
    EXPECT_EQ(RendererInternals::revision(renderer), before);
    renderer.setTime(1);
    EXPECT_GT(RendererInternals::revision(renderer), before);
}

TEST_F(Moments, ADescribedAnimationIsLoadedAnew)
{
    SceneDescription d = files();
    d.output.frames = 3;
    d.time.range = {0.5, 2.0};
    Renderer renderer(d);
    const Picture first = renderer.render({d.camera}), last = renderer.render({AnimationFrame{2}});
    renderer.setTime(1);
    renderer.reload(renderer.description());
    EXPECT_EQ(renderer.info().time, 0.5);
    EXPECT_EQ(renderer.render({d.camera}).pixels, first.pixels);
    EXPECT_EQ(renderer.render({AnimationFrame{2}}).pixels, last.pixels);
}

TEST_F(Moments, AllRanksGoBetweenMomentAndAnimation)
{
    SceneDescription d = files();
    d.output.frames = 3;
    d.time.range = {0.0, 2.0};
    Renderer alone(d);
    const std::vector<std::uint8_t> frame = alone.render({AnimationFrame{1}}).pixels, half = at(files(), 0.5).pixels;
    d.run.threads = 1;
    runRanks(3, [&](Communicator& communicator) {
        Renderer one(d, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        one.setTime(0.5);
        const Picture animated = one.render({AnimationFrame{1}}), still = one.render({d.camera});
        if (!communicator.isRoot()) return;
        EXPECT_EQ(animated.pixels, frame);
        EXPECT_EQ(still.pixels, half);
    });
}

TEST_F(Moments, FramesAtOneTimeAreTheSame)
{
    SceneDescription d = builtIn();
    d.output.frames = 3;
    d.time.range = {1.3, 1.3};
    Renderer renderer(d);
    const Picture first = renderer.render({AnimationFrame{0}});
    EXPECT_EQ(renderer.render({AnimationFrame{1}}).pixels, first.pixels);
    EXPECT_EQ(renderer.render({AnimationFrame{2}}).pixels, first.pixels);
}

TEST_F(Moments, TimesOfSurfaceAndFieldAreKnown)
{
    EXPECT_EQ(Renderer(files()).info().times, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(Renderer(builtIn()).info().times.size(), 41u);
    SceneDescription still = bare();
    still.surface.spec = "torus:400";
    still.field.spec = "abc:8,8,8";
    Renderer renderer(still);
    EXPECT_TRUE(renderer.info().times.empty());
    const Picture before = renderer.render({});
    renderer.setTime(3);
    EXPECT_EQ(renderer.render({}).pixels, before.pixels);
}

TEST_F(Moments, AnotherNumberOfTrianglesIsDrawn)
{
    SheetSample fine;
    fine.n = 11;
    fine.shift = {-0.3, 0, 1};
    writeSheetFile(folder_.file("s_1.vtp"), fine);
    Renderer renderer(files());
    EXPECT_EQ(renderer.info().triangles, 32u);
    renderer.setTime(1);
    EXPECT_EQ(renderer.info().triangles, 242u);
    EXPECT_EQ(renderer.render({}).pixels, at(files(), 1).pixels);
    renderer.setTime(1.5);
    EXPECT_EQ(renderer.render({}).pixels, at(files(), 1.5).pixels);
    ASSERT_EQ(RendererInternals::scene(renderer).warnings.size(), 1u);
    renderer.setTime(0.5);
    EXPECT_EQ(RendererInternals::scene(renderer).warnings.size(), 1u) << "it is said once";
}

/// Colours, fit and noise are those of the first moment: only what moves changes.
TEST_F(Moments, WhatDoesNotMoveDoesNotFlicker)
{
    // Two steps whose vectors differ in length alone: streaks have the same direction, so the same bytes.
    SceneDescription d = describe("slice:0,0,1:0,0,1", folder_.file("f_*.vti"), "");
    Renderer renderer(d);
    const Picture first = renderer.render({});
    renderer.setTime(2);
    EXPECT_EQ(renderer.render({}).pixels, first.pixels);
    d.shading.colorBy = "U:mag";
    Renderer colored(d);
    const Picture firstColors = colored.render({});
    colored.setTime(2);
    EXPECT_NE(colored.render({}).pixels, firstColors.pixels) << "longer vectors, another colour of the same range";
}

TEST_F(Moments, ADamagedStepIsOneLineAndTheMomentStays)
{
    Renderer renderer(files());
    writeBytes(folder_.file("f_2.vti"), "damaged");
    const Picture first = renderer.render({});
    EXPECT_THROW(renderer.setTime(2), InputError);
    EXPECT_EQ(renderer.info().time, 0);
    EXPECT_EQ(renderer.render({}).pixels, first.pixels);
    renderer.setTime(0.5);
    EXPECT_EQ(renderer.render({}).pixels, at(files(), 0.5).pixels);
    EXPECT_THROW(renderer.setTime(std::numeric_limits<double>::quiet_NaN()), InputError);
    EXPECT_THROW(renderer.setTime(std::numeric_limits<double>::infinity()), InputError);
}

TEST_F(Moments, ARendererMayGoWhileAStepIsReadAhead)
{
    for (int i = 0; i < 5; ++i) {
        Renderer renderer(builtIn());
        renderer.setTime(1 + i);
    }
}

void expectSameBytesFromRanks(const SceneDescription& description, int ranks, BrickChoice bricks)
{
    const double moments[] = {0.5, 1.25, 1.5, 2.0, 0.25};
    std::vector<Picture> alone;
    Renderer renderer(description);
    for (const double moment : moments) {
        renderer.setTime(moment);
        alone.push_back(renderer.render({}));
    }
    SceneDescription together = description;
    together.run.bricks = bricks;
    together.run.threads = 1;
    runRanks(ranks, [&](Communicator& communicator) {
        Renderer one(together, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        for (std::size_t i = 0; i < alone.size(); ++i) {
            one.setTime(moments[i]);
            const Picture picture = one.render({});
            if (communicator.isRoot()) {
                EXPECT_EQ(picture.pixels, alone[i].pixels)
                    << ranks << " ranks, bricks " << nameOf(bricks) << ", time " << moments[i];
            }
        }
    });
}

TEST_F(Moments, SameBytesFromAnyNumberOfRanks)
{
    for (const int ranks : {2, 3, 5}) {
        expectSameBytesFromRanks(files(), ranks, BrickChoice::off);
        expectSameBytesFromRanks(builtIn(), ranks, BrickChoice::off);
    }
}

TEST_F(Moments, SameBytesFromBricks)
{
    for (const int ranks : {2, 5}) {
        expectSameBytesFromRanks(files(), ranks, BrickChoice::on);
        expectSameBytesFromRanks(builtIn(), ranks, BrickChoice::on);
        SceneDescription halves = files();
        halves.field.precision = FieldPrecision::float16;
        expectSameBytesFromRanks(halves, ranks, BrickChoice::on);
    }
}

/// No rank goes on with a moment that the others could not load.
TEST_F(Moments, ADamagedStepIsThrownByAllRanks)
{
    SceneDescription d = files();
    d.run.threads = 1;
    int thrown = 0;
    std::mutex counting;
    runRanks(3, [&](Communicator& communicator) {
        Renderer one(d, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const Picture first = one.render({});
        communicator.barrier();
        if (communicator.isRoot()) writeBytes(folder_.file("s_2.vtp"), "damaged");
        communicator.barrier();
        try {
            one.setTime(2);
        } catch (const InputError&) {
            const std::lock_guard lock(counting);
            ++thrown;
        }
        EXPECT_EQ(one.info().time, 0);
        EXPECT_EQ(one.render({}).pixels, first.pixels);
    });
    EXPECT_EQ(thrown, 3);
}

}  // namespace
}  // namespace aeolic
