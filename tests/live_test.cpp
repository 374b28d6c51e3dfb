#include "aeolic/live.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

#include "aeolic/error.h"
#include "aeolic/stream_client.h"
#include "memory_scenes_testing.h"
#include "ranks/thread_communicator.h"

/// A program that shows what it draws in browsers while it goes on.
namespace aeolic {
namespace {

using namespace std::chrono_literals;
using testkit::MemorySheet;

constexpr int kQuads = 12;

class Program : public testkit::MemoryTest {
protected:
    Program()
    {
        scene_.field.vectors = "tau";
        options_.token = "sixteen.Letters_-1";
        options_.controls = {{"speed", Control::Kind::number, 1, 0, 2, ""},
                             {"step", Control::Kind::button, 0, 0, 1, ""}};
    }

    /// The data of one step; of `ranks` each has its rows.
    static Data step(const MemorySheet& sheet)
    {
        Data data;
        data.surface = sheet.surface();
        return data;
    }
    static MemorySheet sheetOf(int step, int rank = 0, int ranks = 1)
    {
        return MemorySheet(kQuads, 0.2 * step, kQuads * rank / ranks, kQuads * (rank + 1) / ranks);
    }

    /// What the program would draw by itself.
    Picture picture(int number, const SceneDescription& scene, int ranks = 1) const
    {
        Picture drawn;
        runRanks(ranks, [&](Communicator& group) {
            const MemorySheet first = sheetOf(0, group.rank(), ranks), sheet = sheetOf(number, group.rank(), ranks);
            Renderer renderer(scene_, step(first), std::shared_ptr<Communicator>(&group, [](Communicator*) {}));
            renderer.setData(step(sheet));
            renderer.setLic(scene.lic);
            renderer.setSize(scene.output.width, scene.output.height);
            Picture mine = renderer.render(scene.camera);
            if (group.isRoot()) drawn = std::move(mine);
        });
        return drawn;
    }

    /// Runs a program on `ranks` ranks that serves until `viewer` has come to its end. `between` is called on each rank
    /// between two calls of serve().
    void run(int ranks, const std::function<void(const std::string& address)>& viewer,
             const std::function<void(Renderer&, Live&, int rank)>& between = {})
    {
        runRanks(ranks, [&](Communicator& group) {
            const std::shared_ptr<Communicator> all(&group, [](Communicator*) {});
            const MemorySheet sheet = sheetOf(0, group.rank(), ranks);
            Renderer renderer(scene_, step(sheet), all);
            Live live(renderer, options_);
            EXPECT_EQ(live.address().empty(), group.rank() != 0);
            std::future<void> watching;
            if (group.isRoot()) watching = std::async(std::launch::async, [&] { viewer(live.address()); });
            for (bool ends = false; !ends;) {
                EXPECT_TRUE(live.serve(renderer, 5ms));
                if (between) between(renderer, live, group.rank());
                Bytes over(1, std::byte(group.isRoot() && watching.wait_for(0s) == std::future_status::ready));
                group.broadcast(over);
                ends = over[0] != std::byte(0);
            }
            if (group.isRoot()) watching.get();
            EXPECT_EQ(renderer.description().output.width, scene_.output.width) << "the program's own size again";
            EXPECT_EQ(renderer.description().lic.steps, scene_.lic.steps);
            EXPECT_EQ(renderer.description().shading.colorMap, scene_.shading.colorMap);
        });
    }

    static StreamView viewOf(int width, int height, const std::string& options)
    {
        StreamView view;
        view.width = width;
        view.height = height;
        view.options = options;
        return view;
    }

    LiveOptions options_;
};

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
    other.camera.azimuthDeg = 70;
    run(GetParam(), [&](const std::string& address) {
        StreamClient viewer(address), second(address);
        const std::string camera = R"({"camera":{"azimuthDeg":70},"lic":{"steps":25}})";
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
            renderer.ranks()->broadcast(told);
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
    options_.reload = [](Renderer& of, const SceneDescription& next, const ProgressFunction& report) {
        of.reload(next, report);
    };
    Live live(renderer, options_);
    auto watching = std::async(std::launch::async, [&] {
        StreamClient viewer(live.address());
        viewer.grab(viewOf(90, 70, ""));
        viewer.change(R"({"colorBy":"q"})");
        return viewer.nextFrame().picture.pixels;
    });
    while (watching.wait_for(0s) != std::future_status::ready) live.serve(renderer, 5ms);
    scene.shading.colorBy = "q";
    EXPECT_EQ(watching.get(), Renderer(scene).render(scene.camera).pixels);
    EXPECT_EQ(renderer.description().shading.colorBy, "q");
}

/// The moment that viewers chose stays when something else is loaded, and so does the program's animation.
TEST_F(Program, ViewersMomentLeavesTheAnimation)
{
    SceneDescription scene = scene_;
    scene.surface.spec = "wave";
    scene.field.spec = "gyre";
    scene.field.vectors.clear();
    scene.shading.scalarBar = false;  // In a still it may stand in another corner.
    scene.output.frames = 3;
    scene.time.range = {0.0, 3.0};
    Renderer renderer(scene);
    options_.reload = [](Renderer& of, const SceneDescription& next, const ProgressFunction& report) {
        of.reload(next, report);
    };
    Live live(renderer, options_);
    auto watching = std::async(std::launch::async, [&] {
        StreamClient viewer(live.address());
        viewer.grab(viewOf(90, 70, ""));
        viewer.change(R"({"time":1})");
        std::vector<std::vector<std::uint8_t>> pictures{viewer.nextFrame().picture.pixels};
        viewer.change(R"({"colorBy":"gyre:mag"})");
        pictures.push_back(viewer.nextFrame().picture.pixels);
        return pictures;
    });
    while (watching.wait_for(0s) != std::future_status::ready) live.serve(renderer, 5ms);
    const auto pictures = watching.get();
    SceneDescription still = scene;
    still.time = {1.0, std::nullopt};
    EXPECT_EQ(pictures[0], Renderer(still).render(scene.camera).pixels);
    scene.shading.colorBy = still.shading.colorBy = "gyre:mag";
    EXPECT_EQ(pictures[1], Renderer(still).render(scene.camera).pixels);
    EXPECT_EQ(renderer.info().time, 1);
    EXPECT_EQ(renderer.description().time.range, scene.time.range);
    EXPECT_EQ(renderer.renderFrame(2).pixels, Renderer(scene).renderFrame(2).pixels);
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
    const auto both = Renderer(scene).render(scene.camera).pixels;
    scene.surfaces[1].shown = false;
    const auto one = Renderer(scene).render(scene.camera).pixels;
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
    EXPECT_EQ(renderer.render(scene_.camera).pixels, picture(0, scene_).pixels) << "and it goes on";
}

TEST_F(Program, WrongOptionsAreRefusedOnAllRanks)
{
    const MemorySheet sheet = sheetOf(0);
    Renderer renderer(scene_, step(sheet));
    const Live first(renderer, options_);
    const auto complaint = [&](const std::function<void(LiveOptions&)>& change) {
        LiveOptions options = options_;
        change(options);
        std::atomic<int> refused{0};
        std::string line;
        runRanks(2, [&](Communicator& group) {
            const MemorySheet part = sheetOf(0, group.rank(), 2);
            Renderer of(scene_, step(part), std::shared_ptr<Communicator>(&group, [](Communicator*) {}));
            try {
                const Live live(of, options);
            } catch (const InputError& error) {
                if (group.isRoot()) line = error.what();
                ++refused;
            }
        });
        EXPECT_EQ(refused, 2);
        return line;
    };
    const std::string port = first.address().substr(first.address().rfind(':') + 1, 5);
    EXPECT_NE(complaint([&](LiveOptions& o) { o.port = std::uint16_t(std::stoi(port)); }).find("in use"),
              std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.token = "short"; }).find("16 to 256"), std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.host = "no.such.host.invalid"; }).find("no.such.host"),
              std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.host = ""; }).find("host: found ''"), std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.largestSide = 0; }).find("largestSide: found 0"), std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.controls[1].name = "speed"; }).find("found twice"), std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.title = "\xe4"; }).find("title: found '\xe4'; expected text in UTF-8"),
              std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.controls[0].unit = "\xb0"; }).find("control speed: found"),
              std::string::npos);
    EXPECT_NE(complaint([](LiveOptions& o) { o.controls[0].name = "\xff"; }).find("in UTF-8"), std::string::npos);
}

TEST_F(Program, RanksThatShowDifferentControlsOrSetThemOtherwiseAreTold)
{
    std::vector<std::string> told(2);
    runRanks(2, [&](Communicator& group) {
        const MemorySheet part = sheetOf(0, group.rank(), 2);
        Renderer renderer(scene_, step(part), std::shared_ptr<Communicator>(&group, [](Communicator*) {}));
        LiveOptions other = options_;
        if (group.rank() == 1) other.controls[0].hi = 3;
        std::string& mine = told[std::size_t(group.rank())];
        try {
            const Live live(renderer, other);
        } catch (const InputError& error) {
            mine = error.what();
        }
        Live live(renderer, options_);
        try {
            live.setValue("speed", 0.5 * group.rank());
        } catch (const InputError& error) {
            mine += std::string("\n") + error.what();
        }
        live.setValue("speed", 0.5);
        EXPECT_EQ(live.value("speed"), 0.5);
        EXPECT_THROW(live.setValue("none", 1), std::out_of_range);
    });
    EXPECT_EQ(told[0],
              "the options of Live: rank 1 has '\"hi\": 3.0'; expected '\"hi\": 2.0' as on rank 0\n"
              "setValue: rank 1 has 'speed = 0.5'; expected 'speed = 0' as on rank 0");
    EXPECT_EQ(told[1], told[0]);
}

/// Rank 0 serves while the other one does something else: both are told, and go on.
TEST_F(Program, DifferentCallsOfItsRanks)
{
    using Other = std::function<void(Renderer&, Live&)>;
    const std::pair<Other, const char*> others[] = {
        {[&](Renderer& renderer, Live&) { renderer.render(scene_.camera); }, "render"},
        {[](Renderer& renderer, Live&) { renderer.setSize(40, 30); }, "setSize"},
        {[](Renderer&, Live& live) { live.setValue("speed", 0.5); }, "setValue"},
        {[&](Renderer& renderer, Live&) { const Live another(renderer, options_); }, "Live"},
    };
    for (const auto& [other, name] : others) {
        std::vector<std::string> told(2, "nothing");
        Picture after;
        runRanks(2, [&](Communicator& group) {
            const MemorySheet part = sheetOf(0, group.rank(), 2);
            Renderer renderer(scene_, step(part), std::shared_ptr<Communicator>(&group, [](Communicator*) {}));
            Live live(renderer, options_);
            try {
                if (group.isRoot())
                    live.serve(renderer);
                else
                    other(renderer, live);
            } catch (const InputError& error) {
                told[std::size_t(group.rank())] = error.what();
            }
            EXPECT_TRUE(live.serve(renderer));
            EXPECT_EQ(live.value("speed"), 1);
            Picture mine = renderer.render(scene_.camera);
            if (group.isRoot()) after = std::move(mine);
        });
        EXPECT_EQ(told[0], std::string("the ranks' calls: rank 1 has '") + name + "'; expected 'serve' as on rank 0");
        EXPECT_EQ(told[1], told[0]);
        EXPECT_EQ(after.pixels, picture(0, scene_, 2).pixels);
    }
}

TEST_F(Program, OneThatWasMovedElsewhereSaysSo)
{
    const MemorySheet sheet = sheetOf(0);
    Renderer renderer(scene_, step(sheet));
    Live first(renderer, options_);
    Live live = std::move(first);
    EXPECT_THROW(first.serve(renderer), std::logic_error);      // NOLINT(bugprone-use-after-move)
    EXPECT_THROW(first.address(), std::logic_error);            // NOLINT(bugprone-use-after-move)
    EXPECT_THROW(first.waitForRequest(0ms), std::logic_error);  // NOLINT(bugprone-use-after-move)
    EXPECT_TRUE(live.serve(renderer));
    Renderer gone = std::move(renderer);
    EXPECT_THROW(live.serve(renderer), std::logic_error);  // NOLINT(bugprone-use-after-move)
    first = std::move(live);
    EXPECT_TRUE(first.serve(gone));
}

}  // namespace
}  // namespace aeolic
