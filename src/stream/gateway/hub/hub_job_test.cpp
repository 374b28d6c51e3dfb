#include "stream/gateway/hub/hub_testing.h"

/// The job that dies and comes back, or never starts.
namespace aeolic::stream {
namespace {

using test::FakeViewer;
using Numbers = std::vector<std::uint32_t>;

class HubJob : public test::HubTest {
protected:
    FakeViewer a, b;
};

TEST_F(HubJob, TheFirstSceneCannotBeLoaded)
{
    hub.jobStarting();
    hub.jobStarted(1);
    const Json asked = loads().at(0);
    EXPECT_FALSE(hub.sceneError());
    say(MessageType::notice, {{"level", "error"}, {"message", "car.vtp: cannot be opened"}, {"load", asked["load"]}});
    EXPECT_EQ(hub.sceneError(), "car.vtp: cannot be opened");
    EXPECT_EQ(hub.status().state, "failed");
}

TEST_F(HubJob, AJobThatDiesMidFrameDrawsTheViewAgain)
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

TEST_F(HubJob, ViewsThatComeWhileTheJobIsAwayAreDrawnWhenItIsBack)
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

TEST_F(HubJob, AnAwayJobKeepsTheCreditRight)
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

TEST_F(HubJob, AViewThatEndsTheJobTwiceIsNotTriedAgain)
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

TEST_F(HubJob, AJobThatDiesLoadingAChangeComesBackWithTheSceneBefore)
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

TEST_F(HubJob, ChangesWhileTheJobIsAwayWaitForIt)
{
    startJob();
    join(a);
    hub.jobEnded("x");
    change(a, R"({"colorBy":"p","change":3})");
    change(a, R"({"colorBy":"q","change":4})");
    EXPECT_EQ(a.errors(), "");
    EXPECT_TRUE(a.answered().empty());
    startJob();
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0]["scene"]["shading"]["colorBy"], "q") << "the newest";
    sceneLoaded(asked[0]);
    EXPECT_EQ(a.answered(), Numbers{4});
}

TEST_F(HubJob, ChangesThatNobodyWillLoadAreRefusedInWords)
{
    startJob();
    join(a);
    join(b);
    hub.jobEnded("x");
    change(a, R"({"colorBy":"p","change":3})");
    hub.jobGivenUp("given up");
    EXPECT_NE(a.errors(), "");
    EXPECT_EQ(a.answered(), Numbers{3});
    change(b, R"({"colorBy":"p","change":1})");
    EXPECT_NE(b.errors(), "");
    EXPECT_EQ(b.answered(), Numbers{1});
    startJob();
    look(a, 1);
    EXPECT_EQ(onlyDraw().scene.shading.colorBy, "");
}

/// What ended the job is not tried again. What others wanted meanwhile is no part of it.
TEST_F(HubJob, TheWishOfAnotherOutlivesTheJobThatAChangeEnded)
{
    startJob();
    join(a);
    join(b);
    change(a, R"({"surface":"isosurface:p=1","change":1})");
    change(a, R"({"surface":"isosurface:p=2","change":2})");
    change(b, R"({"colorBy":"p","change":1})");
    loads();
    hub.jobEnded("x");
    EXPECT_EQ(a.answered(), Numbers{2});
    EXPECT_TRUE(b.answered().empty());
    startJob();
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0]["scene"]["shading"]["colorBy"], "p");
    EXPECT_EQ(asked[0]["scene"]["surface"]["spec"], Json::parse(sceneToJson({}))["surface"]["spec"]);
}

TEST_F(HubJob, GivenUpIsToldToThoseWhoAreThereAndThoseWhoCome)
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

TEST_F(HubJob, AJobThatDrewNothingSaysSo)
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

TEST_F(HubJob, AJobThatNobodyAskedForAnythingIsNoFailure)
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

TEST_F(HubJob, WhatCannotBeLoadedAgainEndsTheJobAndNotTheServer)
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

TEST_F(HubJob, WhatCannotBeStartedIsTheUsersFaultUnlessItOnceCould)
{
    hub.jobStarting();
    hub.jobCannotStart("--launcher: 'x' cannot be started");
    EXPECT_EQ(hub.sceneError(), "--launcher: 'x' cannot be started");
    EXPECT_EQ(hub.status().state, "failed");
}

TEST_F(HubJob, WhatCouldBeStartedOnceKeepsTheServerForThoseWhoAreThere)
{
    startJob();
    hub.jobEnded("x");
    hub.jobCannotStart("y");
    EXPECT_FALSE(hub.sceneError());
    EXPECT_EQ(hub.status().state, "failed");
}

}  // namespace
}  // namespace aeolic::stream
