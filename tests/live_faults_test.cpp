#include <nlohmann/json.hpp>
#include <thread>

#include "aeolic/error.h"
#include "live_testing.h"

/// What a program that shows its pictures in browsers may do wrong.
namespace aeolic {
namespace {

using namespace std::chrono_literals;
using testkit::MemorySheet;
using testkit::Program;

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
        {[&](Renderer& renderer, Live&) { renderer.render({scene_.camera}); }, "start"},
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
            Picture mine = renderer.render({scene_.camera});
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
