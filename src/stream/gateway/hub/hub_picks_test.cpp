#include "hub_testing.h"

/// Viewers ask what their views show at a pixel.
namespace aeolic::stream {
namespace {

using namespace test;

class HubPicks : public HubTest {
protected:
    void pick(const FakeViewer& viewer, std::uint32_t number, int x = 3, int y = 4, const std::string& options = "{}")
    {
        Json json{{"view", number}, {"moving", false}, {"width", 40}, {"height", 30}, {"x", x}, {"y", y}};
        json.update(Json::parse(options));
        receive(viewer, jsonMessage(MessageType::pick, json.dump()));
    }
    std::vector<ProbeRequest> probes()
    {
        std::vector<ProbeRequest> found;
        for (const WireMessage& message : sentToJob(MessageType::probe)) found.push_back(probeFrom(jsonOf(message)));
        return found;
    }
    void answer(const ProbeRequest& probe, const Json& place = nullptr)
    {
        say(MessageType::picked, {{"viewer", probe.viewer}, {"view", probe.view}, {"tookMs", 2.5}, {"place", place}});
    }
};

TEST_F(HubPicks, TheJobIsAskedAndTheViewerGetsTheAnswer)
{
    startJob();
    FakeViewer a, b;
    join(a);
    join(b);
    pick(a, 9, 31, 4, R"({"camera":{"azimuth":12}})");
    const auto asked = probes();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].x, 31);
    EXPECT_EQ(asked[0].y, 4);
    EXPECT_EQ(asked[0].scene.camera.azimuth, 12);
    EXPECT_EQ(asked[0].scene.output.width, 40);
    answer(asked[0], {{"depth", 3}});
    const auto told = a.taken(MessageType::picked);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(jsonOf(told[0]), (Json{{"view", 9}, {"place", {{"depth", 3}}}}));
    EXPECT_TRUE(b.taken(MessageType::picked).empty());
}

TEST_F(HubPicks, OneIsOnItsWayAndTheNewestWaits)
{
    startJob();
    FakeViewer a, b;
    join(a);
    join(b);
    for (std::uint32_t i = 1; i <= 50; ++i) pick(a, i);
    pick(b, 7);
    auto asked = probes();
    ASSERT_EQ(asked.size(), 2u) << "one for each viewer";
    EXPECT_EQ(asked[0].view, 1u);
    answer(asked[0]);
    EXPECT_EQ(a.taken(MessageType::picked).size(), 1u);
    asked = probes();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].view, 50u);
    answer(asked[0]);
    answer(asked[0]);
    EXPECT_EQ(a.taken(MessageType::picked).size(), 1u) << "twice says nothing";
    EXPECT_TRUE(probes().empty());
}

TEST_F(HubPicks, TheyWaitForTheScene)
{
    FakeViewer a;
    join(a);
    pick(a, 1);
    EXPECT_TRUE(probes().empty());
    startJob();
    hub.tick();
    const auto asked = probes();
    ASSERT_EQ(asked.size(), 1u);
    say(MessageType::notice, {{"level", "error"}, {"message", "pick: in pieces"}, {"pick", a.id}});
    EXPECT_EQ(a.errors(), "pick: in pieces\n");
    pick(a, 2);
    EXPECT_EQ(probes().size(), 1u) << "a refusal is an answer";
}

TEST_F(HubPicks, GoWithTheJobAndWithTheViewer)
{
    startJob();
    FakeViewer a;
    join(a);
    pick(a, 1);
    pick(a, 2);
    probes();
    hub.jobEnded("gone");
    startJob();
    hub.tick();
    EXPECT_TRUE(probes().empty()) << "what may have ended the job is not asked again";
    pick(a, 3);
    const auto asked = probes();
    ASSERT_EQ(asked.size(), 1u);
    hub.leave(a.id);
    answer(asked[0]);
    EXPECT_TRUE(a.taken(MessageType::picked).empty());
}

TEST_F(HubPicks, AreRefusedWhereTheyMakeNoSense)
{
    startJob();
    FakeViewer a;
    join(a);
    EXPECT_THROW(pick(a, 1, 40, 0), ProtocolError);
    EXPECT_THROW(pick(a, 1, 0, 30), ProtocolError);
    EXPECT_THROW(pick(a, 1, -1, 0), ProtocolError);
    EXPECT_THROW(pick(a, 1, 0, 0, R"({"z":1})"), ProtocolError);
    pick(a, 1, 0, 0, R"({"camera":{"azimuth":"east"}})");
    EXPECT_NE(a.errors().find("azimuth"), std::string::npos);
    EXPECT_TRUE(probes().empty());
    EXPECT_THROW(say(MessageType::picked, {{"viewer", a.id}}), ProtocolError);
}

TEST_F(HubPicks, OfAViewThatIsTooLargeAreMovedAlong)
{
    startJob();
    FakeViewer a;
    join(a);
    pick(a, 1, 8191, 100, R"({"width":8192,"height":4096})");
    const auto asked = probes();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].scene.output.width, 4096);
    EXPECT_EQ(asked[0].x, 4095);
    EXPECT_EQ(asked[0].y, 50);
}

}  // namespace
}  // namespace aeolic::stream
