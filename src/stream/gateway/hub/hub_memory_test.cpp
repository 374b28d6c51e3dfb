#include "stream/gateway/hub/hub_testing.h"

/// Viewers that read slowly or nothing: the memory that their pictures take has a bound for all of them together.
namespace aeolic::stream {
namespace {

using test::FakeViewer;
using test::HubTest;

constexpr std::uint64_t kRoom = 100'000;

/// Reads nothing of what it gets, and says that it has shown it.
class SlowViewer : public FakeViewer {
public:
    void close(std::uint16_t code, const std::string& reason) override
    {
        FakeViewer::close(code, reason);
        messages.clear();
        queued = 0;
    }
    void send(WireMessage message) override
    {
        if (!isOpen()) return;
        if (MessageType((*message)[2]) == MessageType::frame && queued++ == 0) oldest = header(message).frame;
        FakeViewer::send(std::move(message));
    }
};

class HubMemory : public HubTest {
protected:
    HubMemory()
        : HubTest([] {
              Hub::Options options;
              options.frameBytes = kRoom;
              return options;
          }())
    {
    }

    /// A finished frame of so many bytes.
    void finishWith(const DrawRequest& draw, std::size_t bytes)
    {
        ByteVector message = beginMessage(MessageType::tile);
        putTileHeader(message, {draw.frame, 0, std::uint32_t(draw.scene.output.height),
                                std::uint32_t(draw.scene.output.width), 0, std::uint8_t(draw.codec), 3, 0});
        putText(message, std::string(bytes, 'x'));
        hub.jobSaid(endMessage(std::move(message)));
        frameEnd(draw);
    }

    /// Every viewer asks for a picture and gets it. Returns how many frames `of` got.
    int turn(const std::vector<FakeViewer*>& viewers, std::uint32_t number, std::size_t bytes, const FakeViewer& of)
    {
        int got = 0;
        for (const FakeViewer* viewer : viewers)
            if (viewer->isOpen()) look(*viewer, number);
        for (auto all = draws(); !all.empty(); all = draws())
            for (const DrawRequest& draw : all) {
                finishWith(draw, bytes);
                got += draw.viewer == of.id;
                for (const FakeViewer* viewer : viewers)
                    if (viewer->id == draw.viewer && viewer->isOpen()) shown(*viewer, draw.frame);
            }
        return got;
    }
};

TEST_F(HubMemory, IsFreeAgainWhenEverybodyHasReadAndLeft)
{
    startJob();
    FakeViewer reader;
    join(reader);
    turn({&reader}, 1, 5000, reader);
    EXPECT_GT(hub.frameBytes(), 5000u);
    EXPECT_LT(hub.frameBytes(), 5200u) << "once, however many hold it";
    reader.messages.clear();
    EXPECT_GT(hub.frameBytes(), 5000u) << "it is kept for those who follow";
    hub.leave(reader.id);
    EXPECT_EQ(hub.frameBytes(), 0u);
}

TEST_F(HubMemory, WhoReadsNothingIsSentAwayBeforeOthersSuffer)
{
    startJob();
    std::vector<SlowViewer> slow(8);
    FakeViewer honest;
    std::vector<FakeViewer*> all{&honest};
    join(honest);
    for (SlowViewer& viewer : slow) {
        join(viewer);
        all.push_back(&viewer);
    }
    for (std::uint32_t number = 1; number <= 50; ++number) {
        EXPECT_EQ(turn(all, number, 16'000, honest), 1) << number;
        EXPECT_LE(hub.frameBytes(), kRoom + 17'000) << number;
        honest.messages.clear();
    }
    EXPECT_TRUE(honest.isOpen());
    const auto sentAway =
        std::count_if(slow.begin(), slow.end(), [](const SlowViewer& viewer) { return !viewer.isOpen(); });
    EXPECT_GT(sentAway, 0);
    for (const SlowViewer& viewer : slow) {
        if (viewer.isOpen()) continue;
        EXPECT_EQ(viewer.closedWith, Goodbye::policyError);
    }
}

TEST_F(HubMemory, WhoHasBeenReadingForLongestGoesFirst)
{
    startJob();
    std::vector<SlowViewer> slow(4);
    FakeViewer honest;
    join(honest);
    const auto isGone = [](const SlowViewer& viewer) { return !viewer.isOpen(); };
    const auto gone = [&] { return std::count_if(slow.begin(), slow.end(), isGone); };
    for (SlowViewer& viewer : slow) {
        join(viewer);
        turn({&viewer}, 1, 10'000, viewer);
    }
    ASSERT_EQ(gone(), 0);
    for (std::uint32_t number = 1; number <= 20 && gone() == 0; ++number)
        turn({&slow[3], &honest}, number, 30'000, honest);
    EXPECT_EQ(gone(), 1);
    EXPECT_TRUE(isGone(slow[0]));
}

TEST_F(HubMemory, AFollowerGetsAPictureThatWasDropped)
{
    startJob();
    std::vector<SlowViewer> slow(6);
    FakeViewer honest, follower;
    join(honest);
    turn({&honest}, 1, 20'000, honest);
    honest.messages.clear();
    std::vector<FakeViewer*> all;
    for (SlowViewer& viewer : slow) {
        join(viewer);
        all.push_back(&viewer);
    }
    for (std::uint32_t number = 1; number <= 3; ++number) turn(all, number, 30'000, honest);
    join(follower);
    follow(follower, honest.id);
    for (const DrawRequest& draw : draws()) finishWith(draw, 1000);
    EXPECT_EQ(follower.ended().size(), 1u);
}

TEST_F(HubMemory, APictureForWhichThereIsNoRoomIsRefusedInWords)
{
    startJob();
    FakeViewer viewer;
    join(viewer);
    look(viewer, 1, false, "{}", 200, 100);
    EXPECT_NE(viewer.errors().find("--viewer-memory"), std::string::npos);
    EXPECT_TRUE(draws().empty());
    look(viewer, 2, false, "{}", 60, 100);
    EXPECT_EQ(viewer.errors(), "");
    EXPECT_EQ(draws().size(), 1u);
}

}  // namespace
}  // namespace aeolic::stream
