#include <algorithm>
#include <chrono>
#include <map>

#include "stream/gateway/hub/hub_testing.h"

/// Which view is drawn next, and how long one picture may take: costly pictures cost their own viewer alone.
namespace aeolic::stream {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::FakeViewer;
using test::HubTest;

class HubTurns : public HubTest {
protected:
    /// Draws pictures for so long, each viewer asking all the time. `ms`: what a picture of each takes. Returns how
    /// much time each had.
    std::map<std::uint32_t, double> drawFor(const std::map<const FakeViewer*, int>& ms, seconds time)
    {
        std::map<std::uint32_t, double> had;
        for (const auto end = now + time; now < end;) {
            for (const auto& [viewer, cost] : ms) look(*viewer, ++number_);
            for (const DrawRequest& draw : draws()) {
                const auto of = std::find_if(ms.begin(), ms.end(),
                                             [&](const auto& entry) { return entry.first->id == draw.viewer; });
                if (of == ms.end()) {  // Left over from before.
                    finish(draw);
                    continue;
                }
                now += milliseconds(of->second);
                had[draw.viewer] += of->second;
                finish(draw);
                shown(*of->first, draw.frame);
            }
        }
        return had;
    }
    void endWith(const DrawRequest& draw, double tracedMs)
    {
        tile(draw, 0, draw.scene.output.height);
        hub.jobSaid(frameEndMessage(draw.frame, Json{{"stagesMs", {{"convolve", tracedMs}}}}.dump()));
    }

    std::uint32_t number_ = 0;
    FakeViewer a, b, c, costly;
};

TEST_F(HubTurns, EqualViewersGetAsManyPictures)
{
    startJob();
    for (FakeViewer* viewer : {&a, &b, &c}) join(*viewer);
    const auto had = drawFor({{&a, 20}, {&b, 20}, {&c, 20}}, seconds(30));
    for (const auto& [id, time] : had) EXPECT_NEAR(time, 10'000, 40);
}

TEST_F(HubTurns, WhoAsksForCostlyPicturesGetsLessTimeThanOthers)
{
    startJob();
    for (FakeViewer* viewer : {&a, &b, &c, &costly}) join(*viewer);
    drawFor({{&a, 20}, {&b, 20}, {&c, 20}}, seconds(1));
    const auto had = drawFor({{&a, 20}, {&b, 20}, {&c, 20}, {&costly, 2000}}, seconds(300));
    EXPECT_LT(had.at(costly.id), 0.1 * 300'000);
    EXPECT_GT(had.at(costly.id), 0) << "but not none";
    for (const FakeViewer* viewer : {&a, &b, &c}) EXPECT_GT(had.at(viewer->id), 0.29 * 300'000);
}

/// Viewers take a moment to ask again. A costly picture that began in each such moment would take nearly all the time.
TEST_F(HubTurns, ACostlyPictureDoesNotSlipInBetweenTwoViewsOfOthers)
{
    startJob();
    join(a);
    join(costly);
    double costlyMs = 0, allMs = 0;
    look(a, 1);
    for (DrawRequest draw = onlyDraw(); allMs < 100'000;) {
        const bool isCostly = draw.viewer == costly.id;
        now += milliseconds(isCostly ? 2000 : 20);
        allMs += isCostly ? 2000 : 20;
        costlyMs += isCostly ? 2000 : 0;
        finish(draw);
        look(costly, ++number_);
        shown(isCostly ? costly : a, draw.frame);
        now += milliseconds(5);
        hub.tick();
        auto next = draws();
        look(a, ++number_);
        if (next.empty()) next = draws();
        for (int i = 0; i < 100 && next.empty(); ++i, next = draws()) {
            now += milliseconds(20);
            hub.tick();
        }
        ASSERT_EQ(next.size(), 1u);
        draw = next[0];
    }
    EXPECT_LT(costlyMs, 0.3 * allMs);
    EXPECT_GT(costlyMs, 0);
}

TEST_F(HubTurns, WhoFloodsViewsGetsFewerPicturesThanOthers)
{
    startJob();
    for (FakeViewer* viewer : {&a, &b, &costly}) join(*viewer);
    std::map<std::uint32_t, int> pictures;
    for (int i = 0; i < 3000; ++i) {
        for (int k = 0; k < 10; ++k) look(costly, ++number_);
        for (FakeViewer* viewer : {&a, &b}) look(*viewer, ++number_);
        for (const DrawRequest& draw : draws()) {
            now += milliseconds(20);
            ++pictures[draw.viewer];
            finish(draw);
            for (const FakeViewer* viewer : {&a, &b, &costly})
                if (viewer->id == draw.viewer) shown(*viewer, draw.frame);
        }
    }
    EXPECT_GE(pictures[a.id], 1300) << "not a third";
    EXPECT_GE(pictures[b.id], 1300);
}

TEST_F(HubTurns, WhoIsAloneIsNotHeldBack)
{
    startJob();
    join(costly);
    const auto had = drawFor({{&costly, 2000}}, seconds(60));
    EXPECT_GE(had.at(costly.id), 60'000);
}

TEST_F(HubTurns, WhoRestedGetsNoMoreAfterwards)
{
    startJob();
    for (FakeViewer* viewer : {&a, &b}) join(*viewer);
    drawFor({{&a, 20}, {&b, 20}}, seconds(2));
    drawFor({{&a, 20}}, seconds(100));
    const auto had = drawFor({{&a, 20}, {&b, 20}}, seconds(10));
    EXPECT_NEAR(had.at(a.id), had.at(b.id), 60);
}

TEST_F(HubTurns, APictureThatWouldTakeTooLongIsRefusedOnceThatIsKnown)
{
    startJob();
    join(a);
    const auto ask = [&](int steps) {
        look(a, ++number_, false, R"({"lic":{"method":"direct","steps":)" + std::to_string(steps) + "}}", 1000, 1000);
    };
    ask(100);  // 200 million samples.
    DrawRequest draw = onlyDraw();
    endWith(draw, 2000);
    shown(a, draw.frame);
    ask(800);  // 16 s, of which 15 are allowed.
    EXPECT_NE(a.errors().find("would take about 16 s"), std::string::npos);
    EXPECT_TRUE(draws().empty());
    ask(700);
    EXPECT_EQ(a.errors(), "");
    draw = onlyDraw();
    endWith(draw, 1000);  // It was faster than expected.
    shown(a, draw.frame);
    ask(800);
    EXPECT_EQ(draws().size(), 1u) << "and that is learnt";
}

TEST_F(HubTurns, ShortPicturesTellNothingAboutLongOnes)
{
    startJob();
    join(a);
    look(a, 1, false, R"({"lic":{"method":"direct","steps":1}})");
    const DrawRequest draw = onlyDraw();
    endWith(draw, 40);
    shown(a, draw.frame);
    look(a, 2, false, R"({"lic":{"method":"direct","steps":500}})", 4000, 4000);
    EXPECT_EQ(a.errors(), "");
}

TEST_F(HubTurns, WhoseViewsEndJobAfterJobWaitsForAMinute)
{
    startJob();
    join(a);
    join(b);
    for (int death = 0; death < 2; ++death) {
        if (death == 0) look(a, ++number_);
        EXPECT_EQ(draws().size(), 1u) << "the same view again";
        hub.jobEnded("the renderer ended");
        startJob();
    }
    a.errors();
    look(a, ++number_);
    EXPECT_TRUE(draws().empty()) << "another view of it";
    look(b, 1);
    finish(onlyDraw());
    now += Hub::kPenalty;
    hub.tick();
    EXPECT_EQ(draws().size(), 1u);
}

}  // namespace
}  // namespace aeolic::stream
