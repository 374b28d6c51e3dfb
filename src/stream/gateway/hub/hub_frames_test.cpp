#include <algorithm>
#include <map>

#include "stream/gateway/hub/hub_testing.h"

/// Which view is drawn next, and which viewers get it.
namespace aeolic::stream {
namespace {

using test::FakeViewer;
using Numbers = std::vector<std::uint32_t>;

class HubFrames : public test::HubTest {
protected:
    void SetUp() override
    {
        startJob();
        join(a);
        join(b);
        join(c);
    }
    FakeViewer a, b, c;
};

TEST_F(HubFrames, AViewIsDrawnAndSentToItsViewerAlone)
{
    look(a, 7, false, R"({"lic":{"steps":5}})");
    const DrawRequest draw = onlyDraw();
    EXPECT_EQ(draw.viewer, a.id);
    EXPECT_EQ(draw.view, 7u);
    EXPECT_EQ(draw.askedWidth, 40u);
    EXPECT_EQ(draw.scene.output.width, 40);
    EXPECT_EQ(draw.scene.output.height, 30);
    EXPECT_EQ(draw.scene.lic.steps, 5);
    tile(draw, 10, 20);
    const auto frames = a.taken(MessageType::frame);
    ASSERT_EQ(frames.size(), 1u) << "before the first tile";
    EXPECT_EQ(FakeViewer::header(frames[0]), (FrameHeader{draw.frame, a.id, 7, 40, 30, 40, true}));
    EXPECT_EQ(a.taken(MessageType::tile).size(), 1u) << "tiles go out as they come";
    EXPECT_TRUE(a.ended().empty());
    frameEnd(draw);
    EXPECT_TRUE(a.ended().empty()) << "rank 0's end may come before another rank's last tile";
    tile(draw, 0, 10);
    EXPECT_EQ(a.taken(MessageType::tile).size(), 1u);
    EXPECT_EQ(a.ended(), Numbers{draw.frame});
    EXPECT_TRUE(b.begun().empty());
    EXPECT_TRUE(b.taken(MessageType::tile).empty());
    EXPECT_TRUE(b.ended().empty());
}

TEST_F(HubFrames, TheNewestViewWinsAndTheOthersAreNeverDrawn)
{
    look(a, 1);
    const DrawRequest first = onlyDraw();
    for (std::uint32_t number = 2; number <= 50; ++number) look(a, number);
    EXPECT_TRUE(draws().empty()) << "one at a time";
    finish(first);
    const DrawRequest second = onlyDraw();
    EXPECT_EQ(second.view, 50u);
    shown(a, first.frame);
    finish(second);
    EXPECT_TRUE(draws().empty()) << "and only once";
}

TEST_F(HubFrames, WhatIsNotWrittenIsInFlightWhateverTheViewerSays)
{
    for (std::uint32_t number = 1; number <= 2; ++number) {
        see(a, number);
        ++a.queued;
    }
    look(a, 3);
    shown(a, 2);
    EXPECT_TRUE(draws().empty()) << "it cannot have shown them";
    look(b, 1);
    finish(onlyDraw());
    EXPECT_TRUE(draws().empty()) << "others are drawn meanwhile";
    --a.queued;
    hub.frameWritten(a.id);
    EXPECT_EQ(onlyDraw().view, 3u);
}

TEST_F(HubFrames, WhoMovesWithoutEndDoesNotStarveTheOthers)
{
    std::map<std::uint32_t, int> drawn;
    for (FakeViewer* viewer : {&a, &b, &c}) look(*viewer, 1);
    DrawRequest draw = onlyDraw();
    for (std::uint32_t i = 0; i < 30; ++i) {
        ++drawn[draw.viewer];
        for (FakeViewer* viewer : {&a, &b, &c})
            for (std::uint32_t k = 0; k < (viewer == &a ? 20u : 1u); ++k) look(*viewer, 2 + 20 * i + k);
        finish(draw);
        for (FakeViewer* viewer : {&a, &b, &c}) shown(*viewer, draw.frame);
        draw = onlyDraw();
    }
    EXPECT_GT(drawn[a.id], 0);
    EXPECT_GE(drawn[b.id], 10);
    EXPECT_GE(drawn[c.id], 10);
}

TEST_F(HubFrames, AViewerThatShowsNothingGetsTwoFrames)
{
    std::vector<DrawRequest> drawn;
    for (std::uint32_t number = 1; number <= 10; ++number) {
        look(a, number);
        for (const DrawRequest& draw : draws()) {
            finish(draw);
            drawn.push_back(draw);
        }
    }
    ASSERT_EQ(drawn.size(), 2u);
    a.messages.clear();
    shown(a, drawn[0].frame);
    const DrawRequest third = onlyDraw();
    EXPECT_EQ(third.view, 10u) << "the newest of those it could not have";
    finish(third);
    look(a, 11);
    EXPECT_TRUE(draws().empty()) << "again two on the way";
    shown(a, third.frame);
    EXPECT_EQ(onlyDraw().view, 11u) << "who shows a frame has shown or dropped those before";
}

TEST_F(HubFrames, ASlowViewerGetsFewerFramesAndCostsAQuickOneNothing)
{
    std::uint32_t quick = 0, slow = 0, slowOwes = 0;
    for (std::uint32_t step = 1; step <= 100; ++step) {
        look(a, step);
        look(b, step);
        for (auto all = draws(); !all.empty(); all = draws())
            for (const DrawRequest& draw : all) {
                finish(draw);
                if (draw.viewer == a.id) ++quick, shown(a, draw.frame);
                if (draw.viewer == b.id) ++slow, slowOwes = draw.frame;
            }
        if (step % 20 == 0 && slowOwes) shown(b, slowOwes);
    }
    EXPECT_EQ(quick, 100u);
    EXPECT_LE(slow, 12u);
    EXPECT_GE(slow, 6u);
}

TEST_F(HubFrames, ShownNumbersThatAreNoneDoNoHarm)
{
    look(a, 1);
    const DrawRequest draw = onlyDraw();
    for (const std::uint32_t number : {0u, 12345u, 0xFFFFFFFFu}) shown(b, number);
    shown(a, 0);
    finish(draw);
    shown(a, draw.frame + 1000);
    look(a, 2);
    EXPECT_EQ(onlyDraw().view, 2u);
    EXPECT_EQ(a.closedWith, 0);
}

TEST_F(HubFrames, MovingPicturesAreJpegAndPicturesAtRestLossless)
{
    look(a, 1, true);
    const DrawRequest moving = onlyDraw();
    EXPECT_EQ(moving.codec, Codec::jpeg);
    finish(moving);
    const auto frames = a.taken(MessageType::frame);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_FALSE(FakeViewer::header(frames[0]).lossless);
    look(a, 2, false);
    EXPECT_EQ(onlyDraw().codec, Codec::png);
}

TEST_F(HubFrames, TransparentPicturesAreNeverJpeg)
{
    look(a, 1, true, R"({"shading":{"background":"transparent"}})");
    EXPECT_NE(onlyDraw().codec, Codec::jpeg);
}

TEST_F(HubFrames, ASlowMachineDrawsMovingPicturesSmallerAndPicturesAtRestFull)
{
    using namespace std::chrono_literals;
    for (std::uint32_t number = 1; number <= 20; ++number) {
        look(a, number, true, "{}", 400, 200);
        const DrawRequest draw = onlyDraw();
        now += 200ms;
        finish(draw);
        now += 1ms;
        shown(a, draw.frame);
    }
    a.messages.clear();
    look(a, 21, true, R"({"lic":{"steps":100}})", 400, 200);
    const DrawRequest moving = onlyDraw();
    EXPECT_EQ(moving.scene.output.width, 100);
    EXPECT_EQ(moving.scene.output.height, 50);
    EXPECT_EQ(moving.askedWidth, 400u);
    EXPECT_EQ(moving.scene.lic.steps, 25) << "streaks as long as in the full picture";
    EXPECT_DOUBLE_EQ(moving.scene.shading.textScale, 0.7) << "a quarter of 10 pixels could not be read";
    finish(moving);
    const auto frames = a.taken(MessageType::frame);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_EQ(FakeViewer::header(frames[0]), (FrameHeader{moving.frame, a.id, 21, 100, 50, 400, false}));
    shown(a, moving.frame);
    look(a, 22, false, "{}", 400, 200);
    const DrawRequest atRest = onlyDraw();
    EXPECT_EQ(atRest.scene.output.width, 400);
    EXPECT_EQ(atRest.scene.lic.steps, SceneDescription{}.lic.steps);
    EXPECT_DOUBLE_EQ(atRest.scene.shading.textScale, 1);
}

TEST_F(HubFrames, AViewerThatLeavesMidFrameTakesNothingAlong)
{
    look(a, 1);
    look(b, 1);
    const DrawRequest draw = onlyDraw();
    tile(draw, 0, 10);
    hub.leave(a.id);
    tile(draw, 10, 20);
    frameEnd(draw);
    EXPECT_EQ(onlyDraw().viewer, b.id) << "and the next one's turn has come";
    EXPECT_TRUE(a.ended().empty());
}

TEST_F(HubFrames, TilesOfFramesThatAreNotDrawnAreLeftAside)
{
    look(a, 1);
    const DrawRequest draw = onlyDraw();
    DrawRequest old = draw;
    old.frame = draw.frame - 1;
    tile(old, 0, 30);
    frameEnd(old);
    EXPECT_TRUE(a.begun().empty());
    finish(draw);
    EXPECT_EQ(a.ended(), Numbers{draw.frame});
    tile(draw, 0, 30);
    frameEnd(draw);
    EXPECT_TRUE(a.ended().empty()) << "a frame ends once";
}

TEST_F(HubFrames, ARankThatSendsRowsTwiceOrBeyondThePictureIsNotBelieved)
{
    look(a, 1);
    const DrawRequest draw = onlyDraw();
    EXPECT_THROW(tile(draw, 0, 31), ProtocolError);
    EXPECT_THROW(tile(draw, 29, 2), ProtocolError);
    EXPECT_THROW(tile(draw, 32767, 1), ProtocolError);
    DrawRequest wide = draw;
    wide.scene.output.width = 41;
    EXPECT_THROW(tile(wide, 0, 1), ProtocolError);
    tile(draw, 0, 10);
    EXPECT_THROW(tile(draw, 9, 2), ProtocolError);
}

TEST_F(HubFrames, AJobThatSaysWhatOnlyOthersMaySayIsNotBelieved)
{
    for (const MessageType type : {MessageType::hello, MessageType::welcome, MessageType::load, MessageType::quit})
        EXPECT_THROW(say(type, Json::object()), ProtocolError);
    EXPECT_THROW(say(MessageType::join, Json::object()), ProtocolError) << "twice";
    look(a, 1);
    EXPECT_THROW(hub.jobSaid(jsonMessage(MessageType::frameEnd, "xyz")), ProtocolError) << "no number";
    for (const MessageType type : {MessageType::scene, MessageType::progress, MessageType::notice}) {
        EXPECT_THROW(hub.jobSaid(jsonMessage(type, "[")), ProtocolError);
        EXPECT_THROW(hub.jobSaid(jsonMessage(type, "[]")), ProtocolError);
        for (const char* wrong : {R"({"load":"1","frame":"1","message":7,"what":7,"fraction":"x"})",
                                  R"({"load":1,"message":7,"what":7,"fraction":"x"})", R"({"frame":{},"message":[]})"})
            try {
                hub.jobSaid(jsonMessage(type, wrong));
            } catch (const ProtocolError&) {  // Nothing else may come out of it.
            }
    }
}

TEST_F(HubFrames, AFrameThatTheJobCannotDrawIsToldAndTheNextIsDrawn)
{
    look(a, 1);
    look(b, 1);
    const DrawRequest draw = onlyDraw();
    say(MessageType::notice, {{"level", "error"}, {"message", "no such array"}, {"frame", draw.frame}});
    EXPECT_EQ(a.errors(), "no such array\n");
    EXPECT_EQ(b.errors(), "");
    EXPECT_EQ(onlyDraw().viewer, b.id);
    look(a, 2);
    EXPECT_TRUE(draws().empty());
}

TEST_F(HubFrames, ViewsThatCannotBeAreToldAtOnceAndTheConnectionStays)
{
    look(a, 1, true, R"({"lic":{"steps":-3}})");
    EXPECT_NE(a.errors().find("lic.steps"), std::string::npos);
    EXPECT_TRUE(draws().empty());
    look(a, 2);
    EXPECT_EQ(onlyDraw().view, 2u);
}

}  // namespace
}  // namespace aeolic::stream
