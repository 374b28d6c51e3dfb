#include "stream/gateway/hub/hub_testing.h"

/// A job that draws a frame while it sends the one before is asked for two at once.
namespace aeolic::stream {
namespace {

using namespace std::chrono_literals;
using test::FakeViewer;
using Numbers = std::vector<std::uint32_t>;

class HubAhead : public test::HubTest {
protected:
    void SetUp() override
    {
        startJob(1, 2);
        join(a);
        join(b);
    }
    /// Starts two views of one viewer; both are being drawn then.
    std::vector<DrawRequest> twoOfOne()
    {
        look(a, 1);
        look(a, 2);
        const auto all = draws();
        EXPECT_EQ(all.size(), 2u);
        return all;
    }
    FakeViewer a, b;
};

TEST_F(HubAhead, TheNextViewIsAskedForBeforeTheFirstIsThere)
{
    const auto both = twoOfOne();
    EXPECT_EQ(both[0].view, 1u);
    EXPECT_EQ(both[1].view, 2u);
    look(a, 3);
    look(b, 1);
    EXPECT_TRUE(draws().empty()) << "two at a time";
    finish(both[0]);
    EXPECT_EQ(onlyDraw().viewer, b.id) << "the first viewer has shown nothing yet";
    finish(both[1]);
    EXPECT_EQ(a.ended(), (Numbers{both[0].frame, both[1].frame}));
    shown(a, both[1].frame);
    EXPECT_EQ(onlyDraw().view, 3u);
}

TEST_F(HubAhead, TilesOfBothGoWhereTheyBelong)
{
    look(a, 1);
    look(b, 1);
    const auto both = draws();
    ASSERT_EQ(both.size(), 2u);
    tile(both[0], 0, 10);
    tile(both[1], 0, 30);  // One rank may be ahead of another.
    frameEnd(both[1]);
    EXPECT_EQ(b.ended(), Numbers{both[1].frame});
    EXPECT_TRUE(a.ended().empty());
    tile(both[0], 10, 20);
    frameEnd(both[0]);
    EXPECT_EQ(a.ended(), Numbers{both[0].frame});
    EXPECT_EQ(a.taken(MessageType::tile).size(), 2u);
    EXPECT_EQ(b.taken(MessageType::tile).size(), 1u);
    EXPECT_EQ(hub.status().state, "ready");
}

/// A frame that waits for the frame before it does not make pictures smaller.
TEST_F(HubAhead, TimeBesideTheFrameBeforeIsNotCounted)
{
    std::uint32_t number = 0;
    for (int round = 0; round < 40; ++round) {
        look(a, ++number, true, "{}", 400, 200);
        look(a, ++number, true, "{}", 400, 200);
        const auto both = draws();
        ASSERT_EQ(both.size(), 2u);
        EXPECT_EQ(both[0].scene.output.width, 400);
        for (const DrawRequest& draw : both) {
            now += 30ms;
            finish(draw);
        }
        for (const DrawRequest& draw : both) shown(a, draw.frame);
    }
}

TEST_F(HubAhead, OneThatCannotBeDrawnLeavesTheOther)
{
    const auto both = twoOfOne();
    say(MessageType::notice, {{"level", "error"}, {"message", "no such array"}, {"frame", both[0].frame}});
    EXPECT_EQ(a.errors(), "no such array\n");
    finish(both[1]);
    EXPECT_EQ(a.ended(), Numbers{both[1].frame});
}

/// A job that dies with two views of one viewer died of one of them.
TEST_F(HubAhead, ADeathCountsOnce)
{
    twoOfOne();
    hub.jobEnded("the renderer ended");
    EXPECT_EQ(a.errors(), "");
    startJob(1, 2);
    EXPECT_EQ(onlyDraw().view, 2u) << "the newest again";
    hub.jobEnded("the renderer ended");
    EXPECT_NE(a.errors().find("ended twice"), std::string::npos);
}

TEST_F(HubAhead, AChangeWaitsForBoth)
{
    const auto both = twoOfOne();
    change(b, R"({"colorBy":"rotation:mag"})");
    look(a, 3);
    finish(both[0]);
    shown(a, both[0].frame);
    EXPECT_TRUE(draws().empty()) << "nothing else is begun meanwhile";
    EXPECT_TRUE(loads().empty());
    finish(both[1]);
    shown(a, both[1].frame);
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    sceneLoaded(asked[0], 2);
    EXPECT_EQ(onlyDraw().view, 3u);
}

/// A job that is restarted on processors draws one frame at a time.
TEST_F(HubAhead, AJobThatDoesNotIsAskedForOneAtATime)
{
    hub.jobEnded("the renderer ended");
    startJob(1, 1);
    look(a, 1);
    look(b, 1);
    EXPECT_EQ(draws().size(), 1u);
    const Json scene = test::jsonOf(a.taken(MessageType::scene).back());
    EXPECT_FALSE(scene.contains("framesInFlight")) << "nothing that viewers need";
}

}  // namespace
}  // namespace aeolic::stream
