#pragma once

#include "aeolic/live.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <future>

#include "aeolic/stream_client.h"
#include "memory_scenes_testing.h"
#include "ranks/thread_communicator.h"

namespace aeolic::testkit {

using namespace std::chrono_literals;

/// A program that shows what it draws in browsers while it goes on.
class Program : public MemoryTest {
protected:
    static constexpr int kQuads = 12;

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
            Picture mine = renderer.render({scene.camera});
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
            EXPECT_EQ(renderer.description().shading.colormap, scene_.shading.colormap);
        });
    }

    /// Serves a renderer of files, which may load others, to a viewer that has its first picture. Gives what `watch`
    /// gives.
    template <class Watch>
    auto served(Renderer& renderer, const Watch& watch)
    {
        options_.reload = [](Renderer& of, const SceneDescription& next, const ProgressFunction& report) {
            of.reload(next, report);
        };
        Live live(renderer, options_);
        auto watching = std::async(std::launch::async, [&] {
            StreamClient viewer(live.address());
            viewer.grab(viewOf(90, 70, ""));
            return watch(viewer);
        });
        while (watching.wait_for(0s) != std::future_status::ready) live.serve(renderer, 5ms);
        return watching.get();
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

}  // namespace aeolic::testkit
