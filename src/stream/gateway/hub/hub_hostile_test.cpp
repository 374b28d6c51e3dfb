#include <chrono>
#include <new>
#include <stdexcept>

#include "stream/gateway/hub/hub_testing.h"

/// Requests that are well formed and absurd, and jobs that do not answer: nobody else is harmed.
namespace aeolic::stream {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::FakeViewer;
using test::HubTest;

class HubHostile : public HubTest {
protected:
    HubHostile() = default;
    explicit HubHostile(Hub::Options options) : HubTest(std::move(options)) {}

    FakeViewer rude, honest;

    /// Everything that a finished frame of `viewer` takes, when it asks for one.
    bool seesAPicture(const FakeViewer& viewer, std::uint32_t number)
    {
        look(viewer, number);
        for (auto all = draws(); !all.empty(); all = draws())
            for (const DrawRequest& draw : all) {
                finish(draw);
                if (draw.viewer == viewer.id) {
                    shown(viewer, draw.frame);
                    return true;
                }
            }
        return false;
    }
};

TEST_F(HubHostile, AnAbsurdMomentIsRefusedAndDrawingGoesOn)
{
    startJob();
    join(rude);
    join(honest);
    for (const char* json : {R"({"time":1e31})", R"({"time":-1e300})"}) {
        EXPECT_NO_THROW(change(rude, json));
        EXPECT_NE(rude.errors(), "") << json;
        EXPECT_TRUE(loads().empty()) << json;
        EXPECT_EQ(honest.errors(), "");
    }
    EXPECT_THROW(change(rude, R"({"time":null})"), ProtocolError);
    EXPECT_TRUE(seesAPicture(honest, 1));
    change(honest, R"({"time":0.5})");
    EXPECT_EQ(loads().size(), 1u) << "what was refused is not kept";
}

TEST_F(HubHostile, NamesThatAreNoTextForAFileAreRefused)
{
    startJob();
    join(rude);
    EXPECT_NO_THROW(change(rude, "{\"colorBy\":\"a\\u0000b\"}"));
    EXPECT_NO_THROW(change(rude, "{\"vectors\":\"\\u0007\"}"));
    EXPECT_NE(rude.errors(), "");
    EXPECT_TRUE(loads().empty());
}

TEST_F(HubHostile, ChangesWithoutEndLeaveEveryoneTheirPictures)
{
    startJob();
    join(rude);
    join(honest);
    int pictures = 0;
    milliseconds drawn{}, loaded{};
    const auto end = now + seconds(10);
    for (std::uint32_t i = 1; now < end; ++i) {
        for (int k = 0; k < 10; ++k) change(rude, k % 2 ? R"({"colorBy":"p"})" : R"({"colorBy":"q"})");
        look(honest, i);
        now += milliseconds(1);
        for (const Json& load : loads()) {
            now += milliseconds(50);
            loaded += milliseconds(50);
            sceneLoaded(load);
        }
        for (const DrawRequest& draw : draws()) {
            now += milliseconds(10);
            drawn += milliseconds(10);
            finish(draw);
            shown(honest, draw.frame);
            ++pictures;
        }
    }
    EXPECT_GE(drawn, 0.85 * loaded) << "as much time as the other, though its changes take more";
    EXPECT_GT(loaded, 0.15 * seconds(10)) << "but the other has its share, too";
    EXPECT_GE(pictures, 350);
}

TEST_F(HubHostile, APictureBeyondTheBudgetIsRefusedInWords)
{
    startJob();
    join(rude);
    join(honest);
    look(rude, 1, false, R"({"lic":{"method":"direct","steps":65536}})", 4096, 4096);
    EXPECT_NE(rude.errors().find("more work"), std::string::npos);
    EXPECT_TRUE(draws().empty());
    look(rude, 2, false, R"({"lic":{"method":"hierarchical","steps":65536}})", 4096, 4096);
    EXPECT_EQ(rude.errors(), "") << "jumps are cheap";
    EXPECT_EQ(draws().size(), 1u);
}

class LargeHub : public HubHostile {
protected:
    LargeHub()
        : HubHostile([] {
              Hub::Options options;
              options.largestSide = 32768;
              options.frameBytes = std::uint64_t{8} << 30;
              return options;
          }())
    {
    }
};

TEST_F(LargeHub, AViewOfMorePixelsThanTravelIsRefused)
{
    startJob();
    join(rude);
    look(rude, 1, false, "{}", 32768, 32768);
    EXPECT_NE(rude.errors().find("million pixels"), std::string::npos);
    look(rude, 2, false, "{}", 16384, 16384);
    EXPECT_EQ(rude.errors(), "");
    EXPECT_EQ(draws().size(), 1u);
}

TEST_F(HubHostile, AJobThatDrawsForTooLongIsOverdueAndItsViewCounts)
{
    startJob();
    join(rude);
    for (int death = 0; death < 2; ++death) {
        if (death == 0) look(rude, 1);
        EXPECT_EQ(draws().size(), 1u);
        now += seconds(59);
        EXPECT_FALSE(hub.overdue());
        now += seconds(2);
        ASSERT_TRUE(hub.overdue());
        hub.jobEnded(*hub.overdue());
        EXPECT_FALSE(hub.overdue()) << "that of the job before";
        hub.jobStarted(1);
        sceneLoaded(loads().at(0));
    }
    EXPECT_TRUE(draws().empty()) << "twice is enough";
    EXPECT_NE(rude.errors().find("twice"), std::string::npos);
}

TEST_F(HubHostile, ALoadThatStandsStillIsOverdueAndOneThatGetsOnIsNot)
{
    startJob();
    join(rude);
    change(rude, R"({"colorBy":"p"})");
    const Json load = loads().at(0);
    for (int minute = 0; minute < 30; ++minute) {
        now += seconds(60);
        say(MessageType::progress, {{"load", load["load"]}, {"what", "reading"}, {"fraction", minute / 30.0}});
        EXPECT_FALSE(hub.overdue());
    }
    now += seconds(601);
    EXPECT_TRUE(hub.overdue());
}

TEST_F(HubHostile, AChangeThatEndedTheJobIsRefusedAndItsAskerWaits)
{
    startJob();
    join(rude);
    join(honest);
    change(rude, R"({"surface":"isosurface:p=1"})");
    EXPECT_EQ(loads().size(), 1u);
    hub.jobEnded("the renderer was ended by signal 9 (Killed)");
    hub.jobStarted(1);
    sceneLoaded(loads().at(0));
    rude.errors();
    change(rude, R"({"colorBy":"p"})");
    EXPECT_NE(rude.errors().find("of yours"), std::string::npos);
    EXPECT_TRUE(loads().empty());
    change(honest, R"({"surface":"isosurface:p=1"})");
    EXPECT_NE(honest.errors().find("ended while loading this"), std::string::npos);
    EXPECT_TRUE(loads().empty());
    now += seconds(1);
    change(honest, R"({"surface":"isosurface:p=2"})");
    const auto other = loads();
    ASSERT_EQ(other.size(), 1u) << "others go on";
    sceneLoaded(other[0]);
    now += Hub::kPenalty + seconds(1);
    change(rude, R"({"colorBy":"p"})");
    EXPECT_EQ(loads().size(), 1u);
}

TEST_F(HubHostile, AJobThatWasGivenUpIsStartedForWhoeverAsksButNotAllTheTime)
{
    startJob();
    join(rude);
    const auto ask = [&] { receive(rude, emptyMessage(MessageType::start)); };
    ask();
    EXPECT_FALSE(hub.takeStartAskedFor()) << "it runs";
    hub.jobEnded("the renderer ended with code 3");
    hub.jobGivenUp("given up");
    ask();
    ask();
    EXPECT_TRUE(hub.takeStartAskedFor());
    EXPECT_FALSE(hub.takeStartAskedFor()) << "once";
    hub.jobGivenUp("given up again");
    ask();
    EXPECT_FALSE(hub.takeStartAskedFor()) << "a moment later";
    now += Hub::kBetweenStarts;
    ask();
    EXPECT_TRUE(hub.takeStartAskedFor());
    startJob();
    EXPECT_EQ(hub.status().state, "ready");
}

/// A port that fails when something is sent.
class BrokenViewer : public FakeViewer {
public:
    void send(WireMessage) override { throw std::runtime_error("no memory"); }
};

TEST_F(HubHostile, WhoFailsWhileJoiningIsNotThere)
{
    startJob();
    join(honest);
    BrokenViewer broken;
    EXPECT_THROW(Seat(hub, broken, {{Codec::png}, false, "broken"}), std::runtime_error);
    EXPECT_EQ(hub.status().viewers, 1);
    EXPECT_TRUE(seesAPicture(honest, 1)) << "its port is not used any more";
}

TEST_F(HubHostile, ASeatIsGivenUpWhateverEndsTheSession)
{
    startJob();
    const auto session = [&] {
        const Seat seat(hub, rude, {{Codec::png}, false, "rude"});
        EXPECT_EQ(hub.status().viewers, 1);
        throw std::bad_alloc();
    };
    EXPECT_THROW(session(), std::bad_alloc);
    EXPECT_EQ(hub.status().viewers, 0);
}

}  // namespace
}  // namespace aeolic::stream
