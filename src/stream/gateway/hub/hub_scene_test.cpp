#include "stream/gateway/hub/hub_testing.h"

/// The scene that all viewers share, and how they change it.
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
    EXPECT_TRUE(b.messages.empty()) << "nobody is told of what takes a moment";
    now += Hub::kNoticeable;
    hub.tick();
    EXPECT_EQ(b.state()["state"], "loading");
    look(a, 2);
    EXPECT_TRUE(draws().empty()) << "not while it is loaded";
    sceneLoaded(asked[0]);
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    EXPECT_EQ(b.taken(MessageType::scene).size(), 1u);
    Numbers drawn;
    const auto drawAll = [&] {
        for (auto all = draws(); !all.empty(); all = draws())
            for (const DrawRequest& draw : all) {
                drawn.push_back(draw.viewer);
                EXPECT_EQ(draw.scene.shading.colorBy, "p");
                finish(draw);
            }
    };
    drawAll();
    now += Hub::kNextView;
    hub.tick();
    drawAll();
    std::sort(drawn.begin(), drawn.end());
    EXPECT_EQ(drawn, (Numbers{a.id, b.id})) << "each once";
}

TEST_F(HubScene, AFrameOfTheSceneBeforeIsFinishedFirst)
{
    startJob();
    join(a);
    look(a, 1);
    const DrawRequest old = onlyDraw();
    tile(old, 0, 10);
    change(a, R"({"colorBy":"p"})");
    EXPECT_TRUE(loads().empty());
    tile(old, 10, 20);
    frameEnd(old);
    EXPECT_EQ(a.ended(), Numbers{old.frame});
    sceneLoaded(loads().at(0));
    const DrawRequest again = onlyDraw();
    EXPECT_EQ(again.scene.shading.colorBy, "p");
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
    const auto second = loads();
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0]["scene"]["shading"]["colorBy"], "p") << "laid over the one that was being loaded";
    EXPECT_EQ(second[0]["scene"]["field"]["vectors"], "V");
    sceneLoaded(second[0]);
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
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
    EXPECT_TRUE(draws().empty()) << "pictures of the same scene stay right";
    look(a, 1);
    for (auto all = draws(); !all.empty(); all = draws())
        for (const DrawRequest& draw : all) {
            EXPECT_EQ(draw.scene.field.vectors, "") << "the scene stays as it was";
            finish(draw);
        }
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
    change(a, R"({"vectors":"","surface":"original","change":7})");
    EXPECT_TRUE(loads().empty());
    EXPECT_TRUE(draws().empty());
    EXPECT_TRUE(a.taken(MessageType::scene).empty()) << "it may be large, and the viewer has it";
    EXPECT_EQ(a.answered(), Numbers{7});
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

}  // namespace
}  // namespace aeolic::stream
