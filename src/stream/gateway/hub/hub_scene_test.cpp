#include "stream/gateway/hub/hub_testing.h"

/// The scene all viewers share, and the job that dies and comes back.
namespace aeolic::stream {
namespace {

using test::FakeViewer;
using Numbers = std::vector<std::uint32_t>;

class HubScene : public test::HubTest {
protected:
    FakeViewer a, b;
};

TEST_F(HubScene, WhoComesBeforeItIsLoadedSeesHowFarItIsAndThenGetsIt)
{
    hub.jobStarting();
    join(a);
    EXPECT_EQ(a.state()["state"], "loading");
    look(a, 1, false);
    EXPECT_TRUE(draws().empty());
    hub.jobStarted(1);
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    say(MessageType::progress, {{"load", asked[0]["load"]}, {"what", "reading U"}, {"fraction", 0.4}});
    const Json state = a.state();
    EXPECT_EQ(state["what"], "reading U");
    EXPECT_EQ(state["fraction"], 0.4);
    EXPECT_TRUE(draws().empty());
    EXPECT_TRUE(a.taken(MessageType::scene).empty());
    sceneLoaded(asked[0]);
    EXPECT_EQ(a.state()["state"], "ready");
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    EXPECT_EQ(onlyDraw().view, 1u) << "what it asked for meanwhile";
}

TEST_F(HubScene, ProgressOfAnotherLoadIsNotShown)
{
    startJob();
    join(a);
    a.messages.clear();
    say(MessageType::progress, {{"load", 1}, {"what", "late"}, {"fraction", 0.4}});
    EXPECT_TRUE(a.taken(MessageType::state).empty());
}

TEST_F(HubScene, AChangeIsLoadedToldAndDrawnForEverybody)
{
    startJob();
    join(a);
    join(b);
    see(a, 1);
    see(b, 1);
    a.messages.clear();
    b.messages.clear();
    change(a, R"({"colorBy":"p","vectors":"U"})");
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0]["scene"]["shading"]["colorBy"], "p");
    EXPECT_EQ(asked[0]["scene"]["field"]["vectors"], "U");
    EXPECT_EQ(b.state()["state"], "loading");
    look(a, 2);
    EXPECT_TRUE(draws().empty()) << "not while it is loaded";
    sceneLoaded(asked[0]);
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    EXPECT_EQ(b.taken(MessageType::scene).size(), 1u);
    Numbers drawn;
    for (auto all = draws(); !all.empty(); all = draws())
        for (const DrawRequest& draw : all) {
            drawn.push_back(draw.viewer);
            EXPECT_EQ(draw.scene.shading.colorBy, "p");
            finish(draw);
        }
    std::sort(drawn.begin(), drawn.end());
    EXPECT_EQ(drawn, (Numbers{a.id, b.id})) << "each once";
}

TEST_F(HubScene, AFrameOfTheSceneBeforeIsGivenUp)
{
    startJob();
    join(a);
    look(a, 1);
    const DrawRequest old = onlyDraw();
    tile(old, 0, 10);
    change(a, R"({"colorBy":"p"})");
    sceneLoaded(loads().at(0));
    const DrawRequest again = onlyDraw();
    EXPECT_GT(again.frame, old.frame);
    tile(old, 10, 20);
    frameEnd(old);
    EXPECT_TRUE(a.ended().empty());
    finish(again);
    EXPECT_EQ(a.ended(), Numbers{again.frame});
}

TEST_F(HubScene, ChangesThatComeDuringALoadAreMergedIntoOneMore)
{
    startJob();
    join(a);
    a.messages.clear();
    change(a, R"({"colorBy":"p"})");
    change(a, R"({"vectors":"U"})");
    change(a, R"({"vectors":"V"})");
    const auto first = loads();
    ASSERT_EQ(first.size(), 1u) << "one load is on its way at a time";
    sceneLoaded(first[0]);
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    now += Hub::kBetweenLoads;
    hub.tick();
    const auto second = loads();
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0]["scene"]["shading"]["colorBy"], "p") << "laid over the one that was being loaded";
    EXPECT_EQ(second[0]["scene"]["field"]["vectors"], "V");
    sceneLoaded(second[0]);
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    now += Hub::kBetweenLoads;
    hub.tick();
    EXPECT_TRUE(loads().empty());
}

TEST_F(HubScene, AChangeThatFailsLeavesTheSceneAndIsToldToWhoAsked)
{
    startJob();
    join(a);
    join(b);
    see(b, 4, false);
    b.messages.clear();
    change(a, R"({"vectors":"nothing"})");
    const Json asked = loads().at(0);
    say(MessageType::notice, {{"level", "error"}, {"message", "vectors: found 'nothing'"}, {"load", asked["load"]}});
    const auto notices = a.taken(MessageType::notice);
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_EQ(test::jsonOf(notices[0])["message"], "vectors: found 'nothing'");
    EXPECT_EQ(test::jsonOf(notices[0])["change"], true);
    EXPECT_EQ(b.errors(), "");
    EXPECT_EQ(a.state()["state"], "ready");
    EXPECT_TRUE(a.taken(MessageType::scene).size() <= 1u);
    EXPECT_TRUE(draws().empty()) << "pictures of the same scene stay right";
    look(a, 1);
    for (auto all = draws(); !all.empty(); all = draws())
        for (const DrawRequest& draw : all) {
            EXPECT_EQ(draw.scene.field.vectors, "") << "the scene stays as it was";
            finish(draw);
        }
    now += Hub::kBetweenLoads;
    change(a, R"({"colorBy":"p"})");
    EXPECT_EQ(loads().at(0)["scene"]["field"]["vectors"], "");
}

TEST_F(HubScene, AChangeToWhatThereIsIsAnsweredWithoutTheJob)
{
    startJob();
    join(a);
    join(b);
    see(b, 1, false);
    a.messages.clear();
    b.messages.clear();
    change(a, R"({"vectors":"","surface":"original"})");
    EXPECT_TRUE(loads().empty());
    EXPECT_TRUE(draws().empty());
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    EXPECT_TRUE(b.messages.empty());
}

TEST_F(HubScene, WhoAsksForWhatIsBeingLoadedIsToldIfItIsRefused)
{
    startJob();
    join(a);
    join(b);
    change(a, R"({"vectors":"nothing"})");
    change(b, R"({"vectors":"nothing"})");
    const auto refuse = [&](const Json& asked) {
        say(MessageType::notice, {{"level", "error"}, {"message", "found 'nothing'"}, {"load", asked["load"]}});
    };
    refuse(loads().at(0));
    EXPECT_NE(a.errors(), "");
    now += Hub::kBetweenLoads;
    hub.tick();
    refuse(loads().at(0));
    EXPECT_NE(b.errors(), "");
}

TEST_F(HubScene, AChangeThatNamesAFileIsRefusedBeforeTheJobHearsOfIt)
{
    startJob();
    join(a);
    change(a, R"({"surface":"/etc/passwd"})");
    EXPECT_TRUE(loads().empty());
    const auto notices = a.taken(MessageType::notice);
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_EQ(test::jsonOf(notices[0])["change"], true);
    EXPECT_EQ(a.closedWith, 0);
}

TEST_F(HubScene, TheFirstSceneCannotBeLoaded)
{
    hub.jobStarting();
    hub.jobStarted(1);
    const Json asked = loads().at(0);
    EXPECT_FALSE(hub.sceneError());
    say(MessageType::notice, {{"level", "error"}, {"message", "car.vtp: cannot be opened"}, {"load", asked["load"]}});
    EXPECT_EQ(hub.sceneError(), "car.vtp: cannot be opened");
    EXPECT_EQ(hub.status().state, "failed");
}

TEST_F(HubScene, AJobThatDiesMidFrameDrawsTheViewAgain)
{
    startJob();
    join(a);
    join(b);
    see(b, 8, false);
    look(a, 1, false);
    const DrawRequest lost = onlyDraw();
    tile(lost, 0, 10);
    a.messages.clear();
    EXPECT_TRUE(hub.jobEnded("the renderer was ended by signal 9 (Killed)")) << "it had drawn before";
    const Json state = a.state();
    EXPECT_EQ(state["state"], "restarting");
    EXPECT_EQ(state["message"], "the renderer was ended by signal 9 (Killed)");
    EXPECT_EQ(state["restarts"], 1);
    tile(lost, 10, 20);  // The job had sent this before it died.
    startJob();
    Numbers drawn;
    for (auto all = draws(); !all.empty(); all = draws())
        for (const DrawRequest& draw : all) {
            EXPECT_GT(draw.frame, lost.frame);
            EXPECT_EQ(draw.view, draw.viewer == a.id ? 1u : 8u) << "every viewer's, as it was";
            drawn.push_back(draw.viewer);
            finish(draw);
        }
    std::sort(drawn.begin(), drawn.end());
    EXPECT_EQ(drawn, (Numbers{a.id, b.id}));
    EXPECT_EQ(a.state()["state"], "ready");
    EXPECT_EQ(a.ended().size(), 1u);
    EXPECT_EQ(a.closedWith, 0);
}

TEST_F(HubScene, ViewsThatComeWhileTheJobIsAwayAreDrawnWhenItIsBack)
{
    startJob();
    join(a);
    look(a, 1);
    onlyDraw();
    hub.jobEnded("x");
    hub.jobWaits("x; starting again in 0.3 s");
    look(a, 2, false);
    look(a, 3, false);
    join(b);
    EXPECT_EQ(b.state()["state"], "restarting");
    EXPECT_EQ(b.taken(MessageType::scene).size(), 1u) << "what was loaded is known";
    EXPECT_TRUE(draws().empty());
    startJob();
    EXPECT_EQ(onlyDraw().view, 3u);
}

TEST_F(HubScene, AnAwayJobKeepsTheCreditRight)
{
    startJob();
    join(a);
    for (int death = 0; death < 5; ++death) {
        look(a, std::uint32_t(death), true);
        EXPECT_EQ(draws().size(), 1u) << death;
        hub.jobEnded("x");
        hub.jobStarting();
        hub.jobStarted(1);
        sceneLoaded(loads().at(0));
        for (const DrawRequest& draw : draws()) finish(draw);
        shown(a, 0xFFFFFFFF);
    }
    see(a, 100);
}

TEST_F(HubScene, AViewThatEndsTheJobTwiceIsNotTriedAgain)
{
    startJob();
    join(a);
    join(b);
    look(a, 13, false);
    onlyDraw();
    hub.jobEnded("x");
    startJob();
    EXPECT_EQ(onlyDraw().view, 13u);
    a.messages.clear();
    hub.jobEnded("x");
    EXPECT_NE(a.errors().find("not tried again"), std::string::npos);
    startJob();
    EXPECT_TRUE(draws().empty());
    see(b, 1);
    now += Hub::kPenalty;
    see(a, 14);  // Another view may be drawn, after a while.
}

TEST_F(HubScene, AJobThatDiesLoadingAChangeComesBackWithTheSceneBefore)
{
    startJob();
    join(a);
    see(a, 1, false);
    change(a, R"({"colorBy":"p"})");
    EXPECT_EQ(loads().at(0)["scene"]["shading"]["colorBy"], "p");
    a.messages.clear();
    hub.jobEnded("x");
    EXPECT_NE(a.errors().find("stays as it was"), std::string::npos);
    hub.jobStarting();
    hub.jobStarted(1);
    const auto again = loads();
    ASSERT_EQ(again.size(), 1u);
    EXPECT_EQ(again[0]["scene"]["shading"]["colorBy"], "");
}

TEST_F(HubScene, ChangesWhileTheJobIsAwayAreRefusedInWords)
{
    startJob();
    join(a);
    hub.jobEnded("x");
    change(a, R"({"colorBy":"p"})");
    EXPECT_NE(a.errors(), "");
    startJob();
    look(a, 1);
    EXPECT_EQ(onlyDraw().scene.shading.colorBy, "");
}

TEST_F(HubScene, GivenUpIsToldToThoseWhoAreThereAndThoseWhoCome)
{
    startJob();
    join(a);
    hub.jobEnded("x");
    hub.jobGivenUp("the renderer ended with code 1; given up after 6 starts without a picture");
    join(b);
    for (FakeViewer* viewer : {&a, &b}) {
        const Json state = viewer->state();
        EXPECT_EQ(state["state"], "failed");
        EXPECT_EQ(state["message"], "the renderer ended with code 1; given up after 6 starts without a picture");
    }
    look(a, 1);
    EXPECT_TRUE(draws().empty());
    EXPECT_EQ(hub.status().state, "failed");
}

TEST_F(HubScene, AJobThatDrewNothingSaysSo)
{
    startJob();
    EXPECT_FALSE(hub.jobEnded("x"));
    startJob();
    join(a);
    look(a, 1);
    finish(onlyDraw());
    EXPECT_TRUE(hub.jobEnded("x"));
    startJob();
    onlyDraw();
    EXPECT_FALSE(hub.jobEnded("x"));
}

TEST_F(HubScene, AJobThatNobodyAskedForAnythingIsNoFailure)
{
    startJob();
    now += Hub::kSettled;
    EXPECT_TRUE(hub.jobEnded("x"));
    hub.jobStarting();
    hub.jobStarted(1);
    now += Hub::kSettled * 100;
    EXPECT_FALSE(hub.jobEnded("x")) << "loading is no use yet";
    EXPECT_EQ(loads().size(), 1u);
    startJob();
    join(a);
    look(a, 1);
    now += Hub::kSettled;
    EXPECT_FALSE(hub.jobEnded("x")) << "it was asked, and never answered";
    EXPECT_FALSE(hub.jobEnded("x")) << "it did not even start";
}

TEST_F(HubScene, WhatCannotBeLoadedAgainEndsTheJobAndNotTheServer)
{
    startJob();
    join(a);
    see(a, 1, false);
    hub.jobEnded("x");
    hub.jobStarting();
    hub.jobStarted(1);
    const Json asked = loads().at(0);
    a.messages.clear();
    say(MessageType::notice, {{"level", "error"}, {"message", "car.vtp: gone"}, {"load", asked["load"]}});
    EXPECT_FALSE(hub.sceneError());
    EXPECT_EQ(hub.loadError(), "car.vtp: gone");
    EXPECT_TRUE(draws().empty()) << "it has no scene";
    hub.jobEnded(*hub.loadError());
    EXPECT_EQ(a.state()["message"], "car.vtp: gone");
    startJob();  // The file is back.
    EXPECT_FALSE(hub.loadError());
    EXPECT_EQ(onlyDraw().view, 1u);
}

TEST_F(HubScene, WhatCannotBeStartedIsTheUsersFaultUnlessItOnceCould)
{
    hub.jobStarting();
    hub.jobCannotStart("--launcher: 'x' cannot be started");
    EXPECT_EQ(hub.sceneError(), "--launcher: 'x' cannot be started");
    EXPECT_EQ(hub.status().state, "failed");
}

TEST_F(HubScene, WhatCouldBeStartedOnceKeepsTheServerForThoseWhoAreThere)
{
    startJob();
    hub.jobEnded("x");
    hub.jobCannotStart("y");
    EXPECT_FALSE(hub.sceneError());
    EXPECT_EQ(hub.status().state, "failed");
}

}  // namespace
}  // namespace aeolic::stream
