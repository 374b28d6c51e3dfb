#include <algorithm>
#include <chrono>
#include <map>

#include "stream/gateway/hub/hub_testing.h"

/// Changes that come one after the other, as while a slider is dragged or time is played.
namespace aeolic::stream {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::FakeViewer;
using Numbers = std::vector<std::uint32_t>;

class HubChanges : public test::HubTest {
protected:
    void SetUp() override
    {
        startJob();
        join(a);
        join(b);
    }
    /// The change that cuts here, with that number.
    static std::string slice(int at, std::uint32_t number, bool moving = true)
    {
        return Json{{"surface", "slice:" + std::to_string(at) + ",0,0:1,0,0"}, {"change", number}, {"moving", moving}}
            .dump();
    }
    static std::string specOf(const Json& load) { return load["scene"]["surface"]["spec"]; }
    /// Loads the scene that is asked for. Fails unless it is one.
    void loadOnly()
    {
        const auto asked = loads();
        ASSERT_EQ(asked.size(), 1u);
        sceneLoaded(asked[0]);
    }
    FakeViewer a, b, c;
};

TEST_F(HubChanges, WhoIsAloneIsServedAtOnceHoweverManyTheyAre)
{
    see(a, 1, false);
    for (int i = 0; i < 200; ++i) {
        change(a, slice(i, std::uint32_t(i)));
        loadOnly();
        const DrawRequest draw = onlyDraw();
        EXPECT_EQ(draw.scene.surface.spec, "slice:" + std::to_string(i) + ",0,0:1,0,0");
        finish(draw);
        shown(a, draw.frame);
        EXPECT_TRUE(draws().empty()) << "one picture a change";
        EXPECT_EQ(a.answered(), Numbers{std::uint32_t(i)});
    }
}

/// A change does not make room for frames that a viewer has not shown.
TEST_F(HubChanges, NoMoreAreLoadedThanTheViewerSees)
{
    see(a, 1, false);
    std::vector<DrawRequest> drawn;
    int loaded = 0;
    for (int i = 0; i < 50; ++i) {
        change(a, slice(i, std::uint32_t(i)));
        for (const Json& load : loads()) {
            ++loaded;
            sceneLoaded(load);
        }
        for (const DrawRequest& draw : draws()) {
            finish(draw);
            drawn.push_back(draw);
        }
    }
    EXPECT_EQ(loaded, 2);
    ASSERT_EQ(drawn.size(), 2u) << "two frames are on their way";
    shown(a, drawn[0].frame);
    const auto next = loads();
    ASSERT_EQ(next.size(), 1u);
    EXPECT_EQ(specOf(next[0]), "slice:49,0,0:1,0,0") << "the newest wish";
    sceneLoaded(next[0]);
    EXPECT_EQ(draws().size(), 1u);
    EXPECT_EQ(a.answered(), (Numbers{0, 1, 49}));
}

TEST_F(HubChanges, WhoNeverSaysWhatItSeesIsServedAfterAWhile)
{
    see(a, 1);
    for (std::uint32_t number = 2; number <= 3; ++number) {
        look(a, number);
        finish(onlyDraw());
    }
    change(a, slice(1, 1));
    EXPECT_TRUE(loads().empty());
    now += Hub::kPatience / 2;
    change(a, slice(2, 2));
    now += Hub::kPatience / 2;
    hub.tick();
    loadOnly();
}

TEST_F(HubChanges, PicturesAreThoseOfMotionUntilTheSceneRests)
{
    for (FakeViewer* viewer : {&a, &b}) see(*viewer, 1, false);
    change(a, slice(1, 1));
    loadOnly();
    for (int i = 0; i < 2; ++i) {
        const DrawRequest draw = onlyDraw();
        EXPECT_EQ(draw.codec, Codec::jpeg) << "for those who watch, too";
        finish(draw);
        shown(draw.viewer == a.id ? a : b, draw.frame);
    }
    EXPECT_TRUE(draws().empty());
    change(a, slice(1, 2, false));
    EXPECT_TRUE(loads().empty()) << "it is there";
    EXPECT_EQ(a.answered(), (Numbers{1, 2}));
    for (int i = 0; i < 2; ++i) {
        const DrawRequest draw = onlyDraw();
        EXPECT_EQ(draw.codec, Codec::png);
        EXPECT_EQ(draw.view, 1u);
        finish(draw);
        shown(draw.viewer == a.id ? a : b, draw.frame);
    }
    EXPECT_TRUE(draws().empty()) << "each once";
}

TEST_F(HubChanges, WhoFollowsBeforeTheSceneRestsIsNotDrawnForItself)
{
    for (FakeViewer* viewer : {&a, &b}) see(*viewer, 1, false);
    change(a, slice(1, 1));
    loadOnly();
    for (int i = 0; i < 2; ++i) {
        const DrawRequest draw = onlyDraw();
        finish(draw);
        shown(draw.viewer == a.id ? a : b, draw.frame);
    }
    follow(b, a.id);
    change(a, slice(1, 2, false));
    const DrawRequest rest = onlyDraw();
    EXPECT_EQ(rest.viewer, a.id);
    finish(rest);
    for (const FakeViewer* viewer : {&a, &b}) shown(*viewer, rest.frame);
    EXPECT_TRUE(draws().empty());
}

TEST_F(HubChanges, TheLastOfThemIsDrawnAtRestAtOnce)
{
    see(a, 1, false);
    change(a, slice(1, 1));
    change(a, slice(2, 2, false));
    loadOnly();
    finish(onlyDraw());
    loadOnly();
    EXPECT_EQ(onlyDraw().codec, Codec::png);
}

TEST_F(HubChanges, TheSceneRestsWhenWhoMovedItIsSilentOrGone)
{
    see(a, 1, false);
    const auto moveBy = [&](FakeViewer& viewer, int at) {
        change(viewer, slice(at, 1));
        loadOnly();
        const DrawRequest draw = onlyDraw();
        EXPECT_EQ(draw.codec, Codec::jpeg);
        finish(draw);
        shown(a, draw.frame);
        hub.tick();
        EXPECT_TRUE(draws().empty());
    };
    moveBy(b, 1);
    now += Hub::kMovesFor;
    hub.tick();
    DrawRequest rest = onlyDraw();
    EXPECT_EQ(rest.codec, Codec::png);
    finish(rest);
    shown(a, rest.frame);
    moveBy(b, 2);
    hub.leave(b.id);
    hub.tick();
    EXPECT_EQ(onlyDraw().codec, Codec::png);
}

TEST_F(HubChanges, AViewThatMovesIsAtRestByItsOwnWordAlone)
{
    see(a, 1, true);
    change(b, slice(1, 1));
    loadOnly();
    now += Hub::kNextView;
    hub.tick();
    const DrawRequest draw = onlyDraw();
    finish(draw);
    shown(a, draw.frame);
    change(b, slice(1, 2, false));
    EXPECT_TRUE(draws().empty()) << "more of its views will follow";
}

TEST_F(HubChanges, TwoWhoBothDragTakeTurnsAndHearOfTheirOwn)
{
    for (FakeViewer* viewer : {&a, &b}) see(*viewer, 1, false);
    std::map<std::string, int> loaded;
    Numbers ofA, ofB;
    for (int i = 1; i <= 300; ++i) {
        now += milliseconds(10);
        change(a, slice(i, std::uint32_t(i)));
        change(b, R"({"vectors":"V)" + std::to_string(i) + R"(","moving":true,"change":)" + std::to_string(1000 + i) +
                      "}");
        for (const Json& load : loads()) {
            now += milliseconds(30);
            ++loaded[specOf(load).substr(0, 5) == "slice" ? "a" : "?"];
            sceneLoaded(load);
        }
        for (const DrawRequest& draw : draws()) {
            now += milliseconds(10);
            finish(draw);
            shown(draw.viewer == a.id ? a : b, draw.frame);
        }
        for (const std::uint32_t number : a.answered()) ofA.push_back(number);
        for (const std::uint32_t number : b.answered()) ofB.push_back(number);
    }
    EXPECT_GT(ofA.size(), 5u);
    EXPECT_GT(ofB.size(), 5u);
    EXPECT_NEAR(double(ofA.size()), double(ofB.size()), 2);
    EXPECT_LE(*std::max_element(ofA.begin(), ofA.end()), 300u);
    EXPECT_GT(*std::min_element(ofB.begin(), ofB.end()), 1000u);
    EXPECT_EQ(a.errors() + b.errors(), "");
}

TEST_F(HubChanges, ARefusedOneTakesNothingAlong)
{
    see(a, 1, false);
    change(a, R"({"vectors":"nothing","change":1})");
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    change(a, R"({"colorBy":"p","change":2})");
    change(b, R"({"time":0.5,"change":1})");
    change(b, R"({"time":1e300,"change":2})");
    EXPECT_NE(b.errors(), "") << "it cannot be, and is not kept";
    EXPECT_EQ(b.answered(), Numbers{}) << "the one before is not done yet";
    say(MessageType::notice, {{"level", "error"}, {"message", "found 'nothing'"}, {"load", asked[0]["load"]}});
    EXPECT_EQ(a.answered(), Numbers{1});
    EXPECT_EQ(b.errors(), "");
    std::vector<Json> last;
    for (auto next = loads(); !next.empty(); next = loads()) {
        last = next;
        EXPECT_EQ(next[0]["scene"]["field"]["vectors"], "");
        sceneLoaded(next[0]);
        for (const DrawRequest& draw : draws()) finish(draw), shown(a, draw.frame);
    }
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0]["scene"]["shading"]["colorBy"], "p");
    EXPECT_EQ(last[0]["scene"]["time"]["moment"], 0.5);
    EXPECT_EQ(a.answered(), Numbers{2});
    EXPECT_EQ(b.answered(), Numbers{2}) << "both of its";
}

TEST_F(HubChanges, ARefusedOneDoesNotAnswerTheOneThatIsLoaded)
{
    change(a, slice(1, 1));
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    change(a, R"({"time":1e300,"change":2})");
    EXPECT_NE(a.errors(), "");
    EXPECT_EQ(a.answered(), Numbers{});
    sceneLoaded(asked[0]);
    EXPECT_EQ(a.answered(), Numbers{2});
}

/// Surfaces are counted by their places. Who counted before one of them was taken away would mean another.
class HubSurfacesTakenAway : public HubChanges {
protected:
    void SetUp() override
    {
        HubChanges::SetUp();
        join(c);
        change(a, R"({"cuts":{"1":"slice:1,0,0:1,0,0","2":"slice:2,0,0:1,0,0","3":"slice:3,0,0:1,0,0"},"change":1})");
        loadOnly();
        for (FakeViewer* viewer : {&a, &b, &c}) viewer->messages.clear();
    }
    static std::vector<std::string> specsOf(const Json& load)
    {
        std::vector<std::string> specs;
        for (const Json& one : load["scene"]["surfaces"]) specs.push_back(one["spec"]);
        return specs;
    }
    const std::string take2_ = R"({"cuts":{"2":null},"places":0,"change":2})";
};

TEST_F(HubSurfacesTakenAway, WhoMovesItMeanwhileIsToldOnce)
{
    change(b, R"({"cuts":{"2":"slice:9,0,0:1,0,0"},"places":0,"change":1,"moving":true})");
    auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    change(a, take2_);
    change(b, R"({"cuts":{"2":"slice:8,0,0:1,0,0"},"places":0,"change":2,"moving":true})");
    while (!asked.empty() && specsOf(asked[0]).size() == 4) sceneLoaded(asked[0]), asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(specsOf(asked[0]).size(), 3u);
    change(b, R"({"cuts":{"2":"slice:7,0,0:1,0,0"},"places":0,"change":3,"moving":true})");
    change(c, R"({"cuts":{"3":"slice:5,0,0:1,0,0"},"places":0,"change":1})");
    EXPECT_EQ(b.errors() + c.errors(), "") << "it is not gone yet";
    sceneLoaded(asked[0]);
    for (FakeViewer* viewer : {&b, &c}) {
        const std::string errors = viewer->errors();
        EXPECT_NE(errors.find("taken a surface away"), std::string::npos);
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1);
        EXPECT_EQ(test::jsonOf(viewer->taken(MessageType::scene).back())["places"], 1);
    }
    EXPECT_EQ(b.answered().back(), 3u);
    EXPECT_EQ(c.answered(), Numbers{1});
    EXPECT_TRUE(loads().empty()) << "nothing else is moved, and nothing comes back";
    change(b, R"({"cuts":{"2":"slice:6,0,0:1,0,0"},"places":0,"change":4})");
    EXPECT_NE(b.errors(), "") << "sent before it heard of that";
    change(b, R"({"cuts":{"2":"slice:6,0,0:1,0,0"},"places":1,"change":5})");
    asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(specsOf(asked[0])[2], "slice:6,0,0:1,0,0") << "the last of those that are left";
}

TEST_F(HubSurfacesTakenAway, WhereThatFailsWhatWaitsIsDone)
{
    change(a, take2_);
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    change(b, R"({"cuts":{"3":"slice:9,0,0:1,0,0"},"places":0,"change":1})");
    say(MessageType::notice, {{"level", "error"}, {"message", "no memory"}, {"load", asked[0]["load"]}});
    const auto next = loads();
    ASSERT_EQ(next.size(), 1u);
    EXPECT_EQ(specsOf(next[0])[3], "slice:9,0,0:1,0,0");
    EXPECT_EQ(b.errors(), "");
}

TEST_F(HubChanges, BackToTheFirstWishIsAChangeToo)
{
    change(a, slice(1, 1));
    loadOnly();
    change(a, slice(2, 2));
    const auto there = loads();
    ASSERT_EQ(there.size(), 1u);
    change(a, slice(1, 3, false));
    sceneLoaded(there[0]);
    const auto back = loads();
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(specOf(back[0]), "slice:1,0,0:1,0,0");
    sceneLoaded(back[0]);
    EXPECT_EQ(a.answered(), (Numbers{1, 2, 3}));
}

TEST_F(HubChanges, WhoLeavesTakesItsWishAlongButNotWhatIsLoaded)
{
    see(b, 1, false);
    change(a, slice(1, 1));
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    change(a, slice(2, 2));
    hub.leave(a.id);
    sceneLoaded(asked[0]);
    EXPECT_EQ(onlyDraw().scene.surface.spec, "slice:1,0,0:1,0,0") << "what everybody sees is what was told";
    hub.tick();
    EXPECT_TRUE(loads().empty());
}

/// A Scene may be large. Who still has pictures to read hears of the newest one alone, before its next picture.
TEST_F(HubChanges, ASlowLineIsToldOfTheNewestSceneOnly)
{
    see(a, 1, false);
    look(b, 1);
    finish(onlyDraw());
    b.messages.clear();
    b.queued = 2;
    for (int i = 0; i < 20; ++i) {
        change(a, slice(i, std::uint32_t(i)));
        loadOnly();
        const DrawRequest draw = onlyDraw();
        finish(draw);
        shown(a, draw.frame);
    }
    EXPECT_TRUE(b.messages.empty());
    b.queued = 0;
    hub.frameWritten(b.id);
    const auto scenes = b.taken(MessageType::scene);
    ASSERT_EQ(scenes.size(), 1u);
    EXPECT_EQ(test::jsonOf(scenes[0])["surface"], "slice:19,0,0:1,0,0");
}

}  // namespace
}  // namespace aeolic::stream
