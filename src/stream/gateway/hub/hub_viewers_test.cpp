#include "stream/gateway/hub/hub_testing.h"

/// Coming, going, following.
namespace aeolic::stream {
namespace {

using test::FakeViewer;
using Numbers = std::vector<std::uint32_t>;

class HubViewers : public test::HubTest {
protected:
    FakeViewer a, b, c;
};

class SmallHub : public test::HubTest {
protected:
    SmallHub() : HubTest(options()) {}
    static Hub::Options options()
    {
        Hub::Options options;
        options.maxViewers = 2;
        options.largestSide = 64;
        return options;
    }
    FakeViewer a, b;
};

TEST_F(HubViewers, AreWelcomedWithWhatTheyNeed)
{
    startJob(3);
    join(a, {Codec::png, Codec::lz4}, "page");
    const auto welcome = a.taken(MessageType::welcome);
    ASSERT_EQ(welcome.size(), 1u);
    const Json json = test::jsonOf(welcome[0]);
    EXPECT_EQ(json["protocol"], 1);
    EXPECT_EQ(json["viewer"], a.id);
    EXPECT_EQ(json["codecs"], Json::parse(R"(["png","lz4"])"));
    EXPECT_EQ(json["limits"]["largestSide"], 4096);
    EXPECT_TRUE(json["version"].is_string());
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u);
    const Json state = a.state();
    EXPECT_EQ(state["state"], "ready");
    EXPECT_EQ(state["ranks"], 3);
    EXPECT_EQ(state["viewers"], Json::parse(R"([{"viewer":1,"name":"page"}])"));
}

TEST_F(HubViewers, HearOfEachOther)
{
    join(a, {Codec::png}, "ann");
    join(b, {Codec::png}, "bob");
    EXPECT_EQ(a.state()["viewers"], Json::parse(R"([{"viewer":1,"name":"ann"},{"viewer":2,"name":"bob"}])"));
    hub.leave(b.id);
    EXPECT_EQ(a.state()["viewers"].size(), 1u);
    join(c);
    EXPECT_EQ(c.id, 3u) << "numbers are not used again";
}

TEST_F(SmallHub, IsFullAtItsLimit)
{
    join(a);
    EXPECT_FALSE(hub.isFull());
    join(b);
    EXPECT_TRUE(hub.isFull());
    hub.leave(a.id);
    EXPECT_FALSE(hub.isFull());
}

TEST_F(SmallHub, CutsSizesDownToItsLimit)
{
    startJob();
    join(a);
    look(a, 1, false, "{}", 6400, 3200);
    const DrawRequest draw = onlyDraw();
    EXPECT_EQ(draw.scene.output.width, 64);
    EXPECT_EQ(draw.scene.output.height, 32);
}

TEST_F(HubViewers, AFollowerThatReadsNothingGetsTheNewestOnceItDoes)
{
    startJob();
    join(a);
    join(b);
    follow(b, a.id);
    b.queued = 2;
    see(a, 1);
    see(a, 2);
    shown(b, 0xFFFFFFFFu);
    EXPECT_TRUE(b.begun().empty());
    b.queued = 1;
    hub.frameWritten(b.id);
    EXPECT_EQ(b.begun(), Numbers{2});
    EXPECT_EQ(b.ended(), Numbers{2});
}

TEST_F(HubViewers, AFollowerGetsTheSameBytes)
{
    startJob();
    join(a);
    join(b);
    follow(b, a.id);
    look(a, 5);
    const DrawRequest draw = onlyDraw();
    finish(draw);
    const auto tilesOfA = a.taken(MessageType::tile), tilesOfB = b.taken(MessageType::tile);
    ASSERT_EQ(tilesOfB.size(), 1u);
    EXPECT_EQ(tilesOfA, tilesOfB) << "not even copied";
    const auto frames = b.taken(MessageType::frame);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_EQ(FakeViewer::header(frames[0]).viewer, a.id);
    EXPECT_EQ(FakeViewer::header(frames[0]).view, 5u);
    EXPECT_EQ(b.ended(), Numbers{draw.frame});
}

TEST_F(HubViewers, AFollowerGetsThePictureThatIsThereAtOnce)
{
    startJob();
    join(a);
    join(b);
    const std::uint32_t frame = see(a, 1);
    follow(b, a.id);
    EXPECT_EQ(b.begun(), Numbers{frame});
    EXPECT_EQ(b.ended(), Numbers{frame});
    EXPECT_TRUE(draws().empty());
}

/// It counts as one that the follower has not shown yet.
TEST_F(HubViewers, AFollowerThatShowsNothingGetsOneMoreThanThePictureThatIsThere)
{
    startJob();
    join(a);
    join(b);
    see(a, 1);
    follow(b, a.id);
    EXPECT_EQ(b.ended().size(), 1u);
    for (std::uint32_t number = 2; number <= 6; ++number) see(a, number);
    EXPECT_EQ(b.ended().size(), 1u);
}

TEST_F(HubViewers, ASlowFollowerCatchesUpWithTheNewest)
{
    startJob();
    join(a);
    join(b);
    follow(b, a.id);
    std::uint32_t last = 0;
    for (std::uint32_t number = 1; number <= 10; ++number) last = see(a, number);
    const Numbers got = b.ended();
    ASSERT_EQ(got.size(), 2u) << "no more than it has shown";
    shown(b, got[0]);
    EXPECT_EQ(b.ended(), Numbers{last}) << "the newest, none of those between";
    shown(b, got[1]);
    EXPECT_TRUE(b.ended().empty()) << "and that once";
}

TEST_F(HubViewers, WhoFollowsIsNotDrawnForItself)
{
    startJob();
    join(a);
    join(b);
    see(b, 1);
    look(a, 1);
    const DrawRequest first = onlyDraw();
    look(b, 2);
    follow(b, a.id);  // Its own view is not wanted any more.
    finish(first);
    EXPECT_TRUE(draws().empty());
    change(a, R"({"colorBy":"p"})");
    sceneLoaded(loads().at(0));
    const DrawRequest again = onlyDraw();
    EXPECT_EQ(again.viewer, a.id);
    finish(again);
    EXPECT_TRUE(draws().empty()) << "after a change of the scene neither";
}

TEST_F(HubViewers, AnOwnViewOrFollowingNobodyEndsFollowing)
{
    startJob();
    join(a);
    join(b);
    follow(b, a.id);
    look(b, 1);
    finish(onlyDraw());
    b.messages.clear();
    see(a, 1);
    EXPECT_TRUE(b.begun().empty());
    follow(b, a.id);
    follow(b, 0);
    b.messages.clear();
    see(a, 2);
    EXPECT_TRUE(b.begun().empty());
}

TEST_F(HubViewers, WhoFollowsInTheMiddleOfAFrameGetsItWhenItIsDone)
{
    startJob();
    join(a);
    join(b);
    look(a, 1, false);
    const DrawRequest draw = onlyDraw();
    tile(draw, 0, 10);
    follow(b, a.id);
    EXPECT_TRUE(b.begun().empty());
    tile(draw, 10, 20);
    frameEnd(draw);
    EXPECT_EQ(b.begun(), Numbers{draw.frame});
    EXPECT_EQ(b.taken(MessageType::tile).size(), 2u);
    EXPECT_EQ(b.ended(), Numbers{draw.frame});
    EXPECT_EQ(a.ended(), Numbers{draw.frame});
}

TEST_F(HubViewers, NobodyFollowsThemselvesOrNobody)
{
    startJob();
    join(a);
    follow(a, a.id);
    EXPECT_NE(a.errors(), "");
    follow(a, 99);
    EXPECT_NE(a.errors(), "");
    see(a, 1);
    EXPECT_EQ(a.closedWith, 0);
}

TEST_F(HubViewers, FollowersOutliveWhomTheyFollow)
{
    startJob();
    join(a);
    join(b);
    follow(b, a.id);
    look(a, 1);
    const DrawRequest draw = onlyDraw();
    tile(draw, 0, 10);
    hub.leave(a.id);
    tile(draw, 10, 20);
    frameEnd(draw);
    EXPECT_EQ(b.ended(), Numbers{draw.frame}) << "the frame that had begun comes to its end";
    shown(b, draw.frame);
    see(b, 1);
}

/// What it looked at before is its own view again.
TEST_F(HubViewers, WhoFollowedSomebodyWhoLeftSeesItsOwnViewOfAnotherScene)
{
    startJob();
    join(a);
    join(b);
    see(b, 7);
    follow(b, a.id);
    hub.leave(a.id);
    change(b, R"({"colorBy":"p"})");
    sceneLoaded(loads().at(0));
    const DrawRequest draw = onlyDraw();
    EXPECT_EQ(draw.viewer, b.id);
    EXPECT_EQ(draw.view, 7u);
}

TEST_F(HubViewers, TwoWhoFollowEachOtherGetNothingAndHarmNobody)
{
    startJob();
    join(a);
    join(b);
    follow(a, b.id);
    follow(b, a.id);
    EXPECT_TRUE(draws().empty());
    see(a, 1);
}

TEST_F(HubViewers, WhoFollowsWithoutJpegWaitsForThePictureAtRestAndSlowsNobody)
{
    startJob();
    join(a, {Codec::jpeg, Codec::png, Codec::lz4});
    join(b, {Codec::png});
    follow(b, a.id);
    for (std::uint32_t view = 1; view < 5; ++view) {
        look(a, view);
        const DrawRequest moving = onlyDraw();
        EXPECT_EQ(moving.codec, Codec::jpeg) << "what the viewer itself can decode";
        finish(moving);
        shown(a, moving.frame);
        EXPECT_TRUE(draws().empty()) << "nothing is drawn for the follower alone";
    }
    EXPECT_TRUE(b.begun().empty());
    look(a, 5, false);
    const DrawRequest still = onlyDraw();
    EXPECT_EQ(still.codec, Codec::png);
    finish(still);
    EXPECT_EQ(b.ended(), Numbers{still.frame});
}

class HubOfLz4 : public test::HubTest {
protected:
    HubOfLz4() : HubTest(options()) {}
    static Hub::Options options()
    {
        Hub::Options options;
        options.codec = Codec::lz4;
        return options;
    }
    FakeViewer a, b;
};

TEST_F(HubOfLz4, APictureThatAFollowerCannotDecodeIsDrawnAgain)
{
    startJob();
    join(a, {Codec::lz4, Codec::png});
    join(b, {Codec::png});
    look(a, 1, false);
    DrawRequest draw = onlyDraw();
    EXPECT_EQ(draw.codec, Codec::lz4);
    finish(draw);
    shown(a, draw.frame);
    follow(b, a.id);
    EXPECT_TRUE(b.begun().empty());
    draw = onlyDraw();
    EXPECT_EQ(draw.viewer, a.id);
    EXPECT_EQ(draw.codec, Codec::png);
    finish(draw);
    EXPECT_EQ(b.ended(), Numbers{draw.frame});
}

TEST_F(HubViewers, HelloTwiceAndWhatOnlyTheServerSaysAreRefused)
{
    join(a);
    EXPECT_THROW(receive(a, jsonMessage(MessageType::hello, R"({"codecs":["png"]})")), ProtocolError);
    EXPECT_THROW(receive(a, jsonMessage(MessageType::welcome, "{}")), ProtocolError);
    EXPECT_THROW(receive(a, jsonMessage(MessageType::shown, "123")), ProtocolError);
    EXPECT_THROW(receive(a, jsonMessage(MessageType::follow, "")), ProtocolError);
}

TEST_F(HubViewers, StatusCountsThem)
{
    EXPECT_EQ(hub.status().state, "loading");
    startJob(2);
    join(a);
    look(a, 1);
    EXPECT_EQ(hub.status().state, "rendering");
    finish(onlyDraw());
    const HubStatus status = hub.status();
    EXPECT_EQ(status.state, "ready");
    EXPECT_EQ(status.ranks, 2);
    EXPECT_EQ(status.viewers, 1);
    EXPECT_EQ(status.restarts, 0);
    EXPECT_EQ(status.frames, 1u);
}

}  // namespace
}  // namespace aeolic::stream
