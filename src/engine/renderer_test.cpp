#include "aeolic/renderer.h"

#include <gtest/gtest.h>
#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "aeolic/error.h"
#include "engine/renderer_internals.h"

namespace aeolic {
namespace {

SceneDescription description()
{
    SceneDescription d;
    d.surface.spec = "torus:2000";
    d.field.spec = "tornado:16,16,16";
    d.lic.method = LicMethod::direct;
    d.lic.steps = 20;
    d.output.width = 90;
    d.output.height = 70;
    d.run.backend = BackendChoice::cpu;
    return d;
}

Picture draw(const SceneDescription& d)
{
    return Renderer(d).render({d.camera});
}

/// Alpha where there is one tells the surface from the background; the plain white of the default does not.
Picture withAlpha(SceneDescription d)
{
    d.shading.background = "transparent";
    return draw(d);
}

TEST(Renderer, RefusesAChoiceThatIsNone)
{
    const auto complaint = [](const std::function<void(RunOptions&)>& change) {
        SceneDescription d = description();
        change(d.run);
        try {
            const Renderer renderer(d);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    EXPECT_EQ(complaint([](RunOptions& run) { run.guard = GuardChoice(2); }),
              "run.guard: found value 2; expected one of bound, estimate");
    EXPECT_EQ(complaint([](RunOptions& run) { run.guardRows = GuardRowsChoice(-1); }),
              "run.guardRows: found value -1; expected one of project, receive, auto");
    EXPECT_EQ(complaint([](RunOptions& run) { run.balance = Balance(4); }),
              "run.balance: found value 4; expected one of static, timing, pixels, hybrid");
    EXPECT_EQ(complaint([](RunOptions& run) { run.backend = BackendChoice(77); }),
              "run.backend: found value 77; expected one of auto, cpu, gl");
}

/// What a program sets between pictures is judged like a description, and a refusal changes nothing.
TEST(Renderer, RefusesOptionsThatADescriptionCouldNotHave)
{
    Renderer renderer(description());
    const Picture before = renderer.render({CameraOptions{}});
    const auto complaint = [&](const std::function<void()>& change) {
        try {
            change();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    const auto ofLic = [&](const std::function<void(LicOptions&)>& change) {
        LicOptions lic = description().lic;
        change(lic);
        return complaint([&] { renderer.setLic(lic); });
    };
    const auto ofShading = [&](const std::function<void(ShadingOptions&)>& change) {
        ShadingOptions shading;
        change(shading);
        return complaint([&] { renderer.setShading(shading); });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ofLic([](LicOptions& lic) { lic.steps = -5; }),
              "lic.steps: found -5; expected a whole number from 1 to 65536");
    EXPECT_NE(ofLic([&](LicOptions& lic) { lic.step = nan; }), "taken");
    EXPECT_NE(ofLic([](LicOptions& lic) { lic.kernel = Kernel(9); }), "taken");
    EXPECT_NE(ofShading([](ShadingOptions& shading) { shading.background = "xyz"; }), "taken");
    EXPECT_NE(ofShading([](ShadingOptions& shading) { shading.colorRange = {{2, 1}}; }), "taken");
    EXPECT_NE(ofShading([&](ShadingOptions& shading) { shading.contrast = nan; }), "taken");
    for (const auto& [width, height] : {std::pair{0, 0}, {-5, -5}, {40000, 1}})
        EXPECT_NE(complaint([&, w = width, h = height] { renderer.setSize(w, h); }), "taken") << width;
    CameraOptions camera;
    camera.fov = 500;
    EXPECT_EQ(complaint([&] { renderer.render({camera}); }),
              "camera.fov: found 500; expected a number from 1e-06 to 170");
    camera = {};
    camera.azimuth = nan;
    EXPECT_NE(complaint([&] { renderer.render({camera}); }), "taken");
    EXPECT_EQ(renderer.render({CameraOptions{}}).pixels, before.pixels);
    EXPECT_EQ(complaint([] { const Renderer none(description(), std::shared_ptr<Communicator>()); }),
              "ranks: found none; expected a communicator, as joinRanks() gives it");
}

TEST(Renderer, RefusesFramesAndMomentsThatThereCannotBe)
{
    SceneDescription scene = description();
    scene.field.spec = "gyre:9,9,9";
    scene.output.frames = 3;
    Renderer renderer(scene);
    for (const int index : {-1, 3, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()})
        EXPECT_THROW(renderer.render({AnimationFrame{index}}), InputError) << index;
    for (const double moment : {1e300, -1e31, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(renderer.setTime(moment), InputError) << moment;
    EXPECT_EQ(renderer.description().time.moment, std::nullopt);
    EXPECT_EQ(renderer.render({AnimationFrame{0}}).pixels, Renderer(scene).render({AnimationFrame{0}}).pixels);
}

/// Whatever draws or tells of it, as JSON too, can count on UTF-8.
TEST(Renderer, RefusesTextThatIsNotUtf8)
{
    Renderer renderer(description());
    ShadingOptions shading;
    shading.title = "K\xe4se";
    try {
        renderer.setShading(shading);
        ADD_FAILURE() << "taken";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), "shading.title: found 'K\xe4se'; expected text in UTF-8");
    }
    SceneDescription scene = description();
    scene.shading = shading;
    EXPECT_THROW(Renderer{scene}, InputError);
}

TEST(Renderer, OneThatWasMovedElsewhereSaysSo)
{
    Renderer first(description());
    const Picture picture = first.render({});
    Renderer second = std::move(first);
    // NOLINTBEGIN(bugprone-use-after-move)
    EXPECT_THROW(first.render({}), std::logic_error);
    EXPECT_THROW(first.finish(), std::logic_error);
    EXPECT_THROW(first.render({AnimationFrame{0}}), std::logic_error);
    EXPECT_THROW(first.setSize(8, 8), std::logic_error);
    EXPECT_THROW(first.setLic({}), std::logic_error);
    EXPECT_THROW(first.setShading({}), std::logic_error);
    EXPECT_THROW(first.setTime(0), std::logic_error);
    EXPECT_THROW(first.setShown({}), std::logic_error);
    EXPECT_THROW(first.setData({}), std::logic_error);
    EXPECT_THROW(first.framesInFlight(), std::logic_error);
    EXPECT_THROW(first.info(), std::logic_error);
    EXPECT_THROW(first.lastFrame(), std::logic_error);
    EXPECT_THROW(first.description(), std::logic_error);
    EXPECT_THROW(RendererInternals::ranks(first), std::logic_error);
    // NOLINTEND(bugprone-use-after-move)
    EXPECT_EQ(second.render({}).pixels, picture.pixels);
    first = std::move(second);
    EXPECT_EQ(first.render({}).pixels, picture.pixels);
}

TEST(Renderer, SameDescriptionSameBytes)
{
    const Picture first = draw(description());
    EXPECT_EQ(first.width, 90);
    EXPECT_EQ(first.height, 70);
    EXPECT_EQ(first.channels, 3);
    EXPECT_EQ(first.pixels.size(), 90u * 70 * 3);
    EXPECT_EQ(first.pixels, draw(description()).pixels);
    SceneDescription threads = description();
    threads.run.threads = 3;
    EXPECT_EQ(first.pixels, draw(threads).pixels);
}

TEST(Renderer, WhatItKeepsBetweenFramesDoesNotShow)
{
    Renderer renderer(description());
    const Picture first = renderer.render({description().camera});
    CameraOptions other;
    other.azimuth = 200;
    EXPECT_NE(renderer.render({other}).pixels, first.pixels);
    EXPECT_EQ(renderer.render({description().camera}).pixels, first.pixels);
}

TEST(Renderer, APictureThatIsKeptForItsMemoryDoesNotShow)
{
    Renderer renderer(description());
    const Picture fresh = renderer.render({description().camera});
    for (const Picture& kept :
         {Picture{300, 200, 4, std::vector<std::uint8_t>(300 * 200 * 4, 7)}, Picture{1, 1, 3, {7, 7, 7}}}) {
        renderer.start({description().camera});
        const Picture picture = renderer.finish(kept);
        EXPECT_EQ(picture.width, fresh.width);
        EXPECT_EQ(picture.channels, fresh.channels);
        EXPECT_EQ(picture.pixels, fresh.pixels);
        renderer.start({description().camera, false});
        EXPECT_EQ(renderer.finish(kept).pixels, fresh.pixels);
    }
}

TEST(Renderer, NewOptionsAreThoseOfANewScene)
{
    Renderer renderer(description());
    renderer.render({});
    SceneDescription d = description();
    d.lic.steps = 50;
    d.lic.kernel = Kernel::hann;
    d.shading.blend = 0.4;
    d.shading.background = "101820";
    d.output.width = 61;
    d.output.height = 93;
    renderer.setLic(d.lic);
    renderer.setShading(d.shading);
    renderer.setSize(d.output.width, d.output.height);
    const Picture changed = renderer.render({});
    EXPECT_EQ(changed.width, 61);
    EXPECT_EQ(changed.height, 93);
    EXPECT_EQ(changed.pixels, draw(d).pixels);
    EXPECT_EQ(renderer.description().lic.steps, 50);
}

/// A new seed must bring new noise, as it does in a new scene.
TEST(Renderer, NewSeedIsThatOfANewScene)
{
    Renderer renderer(description());
    const Picture before = renderer.render({});
    SceneDescription d = description();
    d.lic.seed = 99;
    renderer.setLic(d.lic);
    const Picture after = renderer.render({});
    EXPECT_NE(after.pixels, before.pixels);
    EXPECT_EQ(after.pixels, draw(d).pixels);
}

TEST(Renderer, BlendZeroIsTheLitSurfaceAlone)
{
    SceneDescription d = description();
    d.shading.blend = 0;
    const Picture first = draw(d);
    d.lic.steps = 3;
    d.lic.seed = 5;
    EXPECT_EQ(first.pixels, draw(d).pixels);
    d.shading.blend = 0.1;
    EXPECT_NE(first.pixels, draw(d).pixels);
}

TEST(Renderer, NoLicDrawsNoStreaks)
{
    SceneDescription d = description();
    d.lic.method = LicMethod::none;
    d.shading.lighting = false;
    const Picture picture = withAlpha(d);
    int surface = 0;
    std::uint8_t gray = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        if (picture.pixels[i + 3] == 0) continue;
        if (surface++ == 0) gray = picture.pixels[i];
        ASSERT_EQ(picture.pixels[i], gray) << "pixel " << i / 4;
    }
    EXPECT_GT(surface, 1000);
}

/// Half of the surface is darker than the middle gray, half is lighter, and it is gray.
TEST(Renderer, UnlitFullBlendIsTheToneItself)
{
    SceneDescription d = description();
    d.surface.spec = "sphere:2000";
    d.output.width = d.output.height = 150;
    d.shading.blend = 1;
    d.shading.lighting = false;
    const Picture picture = withAlpha(d);
    ASSERT_EQ(picture.channels, 4);
    int dark = 0, surface = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        if (picture.pixels[i + 3] == 0) continue;
        ASSERT_EQ(picture.pixels[i], picture.pixels[i + 1]);
        ASSERT_EQ(picture.pixels[i], picture.pixels[i + 2]);
        dark += picture.pixels[i] < 128;
        ++surface;
    }
    EXPECT_GT(surface, 8000);
    EXPECT_NEAR(dark, 0.5 * surface, 0.06 * surface);
}

TEST(Renderer, TransparentBackgroundHasAlpha)
{
    SceneDescription jagged = description();
    jagged.shading.antialias = false;
    const Picture picture = withAlpha(jagged);
    EXPECT_EQ(picture.channels, 4);
    ASSERT_EQ(picture.pixels.size(), 90u * 70 * 4);
    EXPECT_EQ(picture.pixels[3], 0);
    int opaque = 0;
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4) {
        EXPECT_TRUE(picture.pixels[i] == 0 || picture.pixels[i] == 255);
        opaque += picture.pixels[i] == 255;
    }
    EXPECT_GT(opaque, 1000);
    EXPECT_LT(opaque, 90 * 70);
}

TEST(Renderer, FramesOfAnAnimationShareTheOrbit)
{
    SceneDescription d = description();
    d.output.frames = 4;
    d.output.orbit = 360;
    Renderer renderer(d);
    EXPECT_EQ(renderer.render({AnimationFrame{0}}).pixels, renderer.render({d.camera}).pixels);
    CameraOptions half = d.camera;
    half.azimuth += 180;
    EXPECT_EQ(renderer.render({AnimationFrame{2}}).pixels, renderer.render({half}).pixels);
}

TEST(Renderer, ScalarBarIsDrawnOnlyWhenAskedFor)
{
    SceneDescription d = description();
    d.shading.colorBy = "tornado:mag";
    d.output.width = d.output.height = 200;
    const Picture with = draw(d);
    d.shading.scalarBar = false;
    const Picture without = draw(d);
    EXPECT_NE(with.pixels, without.pixels);
    bool colored = false;
    for (std::size_t i = 0; i < without.pixels.size(); i += 3) colored |= without.pixels[i] != without.pixels[i + 1];
    EXPECT_TRUE(colored);
}

TEST(Renderer, FarMoreThreadsThanCoresAreNotStarted)
{
    SceneDescription d = description();
    d.run.threads = 1;
    const Picture one = draw(d);
    d.run.threads = 4096;
    Renderer renderer(d);
    const int cores = tbb::info::default_concurrency(), most = std::min(4096, 8 * cores);
    EXPECT_EQ(renderer.info().threads, most);
    const std::string warning = "8 for each of " + std::to_string(cores) + " cores";
    const auto& warnings = renderer.info().warnings;
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [&](const std::string& text) { return text.find(warning) != std::string::npos; }),
              most < 4096 ? 1 : 0);
    EXPECT_EQ(renderer.render({d.camera}).pixels, one.pixels);
}

TEST(Renderer, InfoAndStatsSayWhatHappened)
{
    SceneDescription d = description();
    d.run.threads = 1;
    Renderer renderer(d);
    EXPECT_EQ(renderer.info().backend, "cpu");
    EXPECT_FALSE(renderer.info().simd.empty());
    EXPECT_FALSE(renderer.info().device.empty());
    EXPECT_EQ(renderer.info().threads, 1);
    EXPECT_EQ(renderer.info().fieldBytes, 16u * 16 * 16 * 3 * 4);
    EXPECT_GE(renderer.info().triangles, 2000u);
    renderer.render({});
    EXPECT_GT(renderer.lastFrame().coveredPixels, 1000);
    EXPECT_GT(renderer.lastFrame().totalMs, 0);
}

TEST(Renderer, WrongInputIsOneLine)
{
    SceneDescription d = description();
    d.lic.steps = 0;
    EXPECT_THROW(Renderer{d}, InputError);
    d = description();
    d.run.backend = BackendChoice::gl;
    d.surface.spec = "cube";
    try {
        Renderer renderer(d);
        FAIL() << "a surface that does not exist was drawn";
    } catch (const InputError& e) {
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace aeolic
