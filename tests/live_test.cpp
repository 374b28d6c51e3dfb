#include <atomic>
#include <cstring>
#include <nlohmann/json.hpp>
#include <thread>

#include "aeolic/error.h"
#include "engine/renderer_internals.h"
#include "live_testing.h"

/// A program that shows what it draws in browsers while it goes on.
namespace aeolic {
namespace {

using namespace std::chrono_literals;
using testkit::MemorySheet;
using testkit::Program;

class ProgramOnRanks : public Program, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Live, ProgramOnRanks, testing::Values(1, 3));

TEST_P(ProgramOnRanks, ViewersSeeItsPicturesEachItsOwn)
{
    SceneDescription other = scene_;
    other.output = {};
    other.output.width = 61;
    other.output.height = 40;
    other.lic.steps = 25;
    other.camera = {};
    other.camera.azimuth = 70;
    run(GetParam(), [&](const std::string& address) {
        StreamClient viewer(address), second(address);
        const std::string camera = R"({"camera":{"azimuth":70},"lic":{"steps":25}})";
        EXPECT_EQ(viewer.grab(viewOf(90, 70, "")).picture.pixels, picture(0, scene_).pixels);
        EXPECT_EQ(second.grab(viewOf(61, 40, camera)).picture.pixels, picture(0, other).pixels);
        EXPECT_EQ(viewer.grab(viewOf(90, 70, "")).picture.pixels, picture(0, scene_).pixels);
    });
}

TEST_P(ProgramOnRanks, EveryStepOfItsDataIsShown)
{
    const int ranks = GetParam();
    std::atomic<int> wanted{0};
    std::vector<int> shown(std::size_t(ranks), 0);
    run(
        ranks,
        [&](const std::string& address) {
            StreamClient viewer(address);
            EXPECT_EQ(viewer.grab(viewOf(90, 70, "")).picture.pixels, picture(0, scene_).pixels);
            for (int number = 1; number <= 3; ++number) {
                wanted = number;
                const auto expected = picture(number, scene_, ranks).pixels;
                bool seen = false;
                for (int frames = 0; !seen && frames < 3; ++frames)
                    seen = viewer.nextFrame().picture.pixels == expected;
                EXPECT_TRUE(seen) << number << ": nobody asked again, but it comes";
            }
        },
        [&](Renderer& renderer, Live&, int rank) {
            int next = wanted;
            Bytes told(sizeof next);
            std::memcpy(told.data(), &next, sizeof next);
            RendererInternals::ranks(renderer)->broadcast(told);
            std::memcpy(&next, told.data(), sizeof next);
            if (std::exchange(shown[std::size_t(rank)], next) == next) return;
            const MemorySheet sheet = sheetOf(next, rank, ranks);
            renderer.setData(step(sheet));
        });
}

TEST_P(ProgramOnRanks, ViewersSteerAllRanks)
{
    std::atomic<int> steered{0};
    run(
        GetParam(),
        [&](const std::string& address) {
            StreamClient viewer(address);
            const auto scene = nlohmann::json::parse(viewer.scene());
            EXPECT_EQ(scene["program"]["controls"][0]["name"], "speed");
            EXPECT_EQ(scene["choices"]["surfaces"].size(), 1u);
            viewer.change(R"({"steer":{"speed":0.25,"step":2}})");
            for (int i = 0; i < 500 && steered < GetParam(); ++i) std::this_thread::sleep_for(10ms);
            EXPECT_GE(steered, GetParam());
            const auto after = nlohmann::json::parse(StreamClient(address).scene());
            EXPECT_EQ(after["program"]["controls"][0]["value"], 0.25);
        },
        [&](Renderer&, Live& live, int rank) {
            const bool is = live.value("speed") == 0.25 && live.value("step") == 2;
            static thread_local bool counted = false;
            if (rank == 0 && !is) counted = false;
            if (is && !std::exchange(counted, true)) ++steered;
        });
}

TEST_F(Program, WhatItChangesViewersSee)
{
    std::atomic<bool> changes{false};
    SceneDescription other = scene_;
    other.lic.steps = 30;
    run(
        1,
        [&](const std::string& address) {
            StreamClient viewer(address);
            viewer.grab(viewOf(90, 70, ""));
            changes = true;
            const auto expected = picture(0, other).pixels;
            EXPECT_EQ(viewer.nextFrame().picture.pixels, expected);
            changes = false;
            EXPECT_EQ(viewer.nextFrame().picture.pixels, picture(0, scene_).pixels);
        },
        [&](Renderer& renderer, Live&, int) { renderer.setLic(changes ? other.lic : scene_.lic); });
}

TEST_F(Program, ItsSceneIsItsOwn)
{
    run(1, [&](const std::string& address) {
        StreamClient viewer(address);
        viewer.grab(viewOf(90, 70, ""));
        for (const char* wrong : {R"({"vectors":"cellTau"})", R"({"colorBy":"q"})", R"({"surface":"boundary"})",
                                  R"({"steer":{"sped":1}})", R"({"steer":{"speed":3}})"}) {
            StreamClient asking(address);
            asking.grab(viewOf(9, 9, ""));
            asking.change(wrong);
            EXPECT_THROW(asking.nextFrame(), std::runtime_error) << wrong;
        }
        StreamClient absurd(address);
        absurd.change(R"({"time":1e31})");
        EXPECT_THROW(absurd.nextFrame(), std::runtime_error);
        EXPECT_EQ(viewer.grab(viewOf(90, 70, "")).picture.pixels, picture(0, scene_).pixels);
    });
}

TEST_F(Program, FilesAreLoadedAnewWhereItAllowsThat)
{
    SceneDescription scene = scene_;
    scene.surface.spec = sheetFile();
    Renderer renderer(scene);
    const auto shown = served(renderer, [](StreamClient& viewer) {
        viewer.change(R"({"colorBy":"q"})");
        return viewer.nextFrame().picture.pixels;
    });
    scene.shading.colorBy = "q";
    EXPECT_EQ(shown, Renderer(scene).render({scene.camera}).pixels);
    EXPECT_EQ(renderer.description().shading.colorBy, "q");
}

/// The moment that viewers chose stays when something else is loaded, and so does the program's animation.
TEST_F(Program, ViewersMomentLeavesTheAnimation)
{
    SceneDescription scene = scene_;
    scene.surface.spec = "wave";
    scene.field.spec = "gyre:33,33,33";  // Sanitizers take half a minute for the usual size.
    scene.field.vectors.clear();
    scene.shading.scalarBar = false;  // In a still it may stand in another corner.
    scene.output.frames = 3;
    scene.time.range = {0.0, 3.0};
    Renderer renderer(scene);
    const auto pictures = served(renderer, [](StreamClient& viewer) {
        viewer.change(R"({"time":1})");
        std::vector<std::vector<std::uint8_t>> shown{viewer.nextFrame().picture.pixels};
        viewer.change(R"({"colorBy":"gyre:mag"})");
        shown.push_back(viewer.nextFrame().picture.pixels);
        return shown;
    });
    SceneDescription still = scene;
    still.time = {1.0, std::nullopt};
    EXPECT_EQ(pictures[0], Renderer(still).render({scene.camera}).pixels);
    scene.shading.colorBy = still.shading.colorBy = "gyre:mag";
    EXPECT_EQ(pictures[1], Renderer(still).render({scene.camera}).pixels);
    EXPECT_EQ(renderer.info().time, 1);
    EXPECT_EQ(renderer.description().time.range, scene.time.range);
    EXPECT_EQ(renderer.render({AnimationFrame{2}}).pixels, Renderer(scene).render({AnimationFrame{2}}).pixels);
}

/// Nothing is loaded for that, so no program has to allow it.
TEST_F(Program, ViewersSwitchItsSurfaces)
{
    SceneDescription scene = scene_;
    scene.surfaces.resize(2);
    scene.surfaces[0].spec = sheetFile();
    scene.surfaces[1].spec = "torus";
    scene.surfaces[1].streaks = false;
    Renderer renderer(scene);
    Live live(renderer, options_);
    auto watching = std::async(std::launch::async, [&] {
        StreamClient viewer(live.address());
        viewer.grab(viewOf(90, 70, ""));
        viewer.change(R"({"shown":[true,false]})");
        return viewer.nextFrame().picture.pixels;
    });
    while (watching.wait_for(0s) != std::future_status::ready) live.serve(renderer, 5ms);
    EXPECT_FALSE(renderer.description().surfaces[1].shown);
    const auto both = Renderer(scene).render({scene.camera}).pixels;
    scene.surfaces[1].shown = false;
    const auto one = Renderer(scene).render({scene.camera}).pixels;
    EXPECT_NE(one, both);
    EXPECT_EQ(watching.get(), one);
}

TEST_F(Program, NobodyIsWaitedFor)
{
    const MemorySheet sheet = sheetOf(0);
    Renderer renderer(scene_, step(sheet));
    Live live(renderer, options_);
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(live.serve(renderer));
    EXPECT_FALSE(live.waitForRequest(1ms));
    Live moved = std::move(live);
    EXPECT_TRUE(moved.serve(renderer, 1ms));
}

TEST_F(Program, ViewersHearThatItEnds)
{
    const MemorySheet sheet = sheetOf(0);
    Renderer renderer(scene_, step(sheet));
    std::optional<StreamClient> viewer;
    {
        Live live(renderer, options_);
        auto watching = std::async(std::launch::async, [&] {
            viewer.emplace(live.address());
            viewer->grab(viewOf(9, 9, ""));
        });
        while (watching.wait_for(0s) != std::future_status::ready) live.serve(renderer, 5ms);
    }
    EXPECT_THROW(viewer->nextFrame(), std::runtime_error);
    EXPECT_EQ(renderer.render({scene_.camera}).pixels, picture(0, scene_).pixels) << "and it goes on";
}

}  // namespace
}  // namespace aeolic
