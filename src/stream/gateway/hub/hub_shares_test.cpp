#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <optional>

#include "stream/gateway/hub/hub_testing.h"

/// What honest viewers get while others ask for all that they can: a simulated minute with a job that takes its time.
namespace aeolic::stream {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::FakeViewer;
using test::HubTest;

class HubShares : public HubTest {
protected:
    static constexpr int kHonest = 8;
    static constexpr auto kThought = milliseconds(75);  // From a picture to the next view.
    static constexpr auto kLight = milliseconds(5);     // What a picture of most viewers takes.

    /// A viewer that sends views by the clock.
    struct Rude {
        FakeViewer viewer;
        std::chrono::milliseconds pause, picture;
        int viewsAtOnce;
        int width, height;
        std::string options;
        bool moving = true;
        bool lies = false;        // It says that it has shown what nobody has drawn yet.
        bool comesAgain = false;  // After each picture under another number.
        SteadyClock::time_point next{};
        milliseconds had{0};
        int pictures = 0;
    };

    HubShares()
    {
        startJob();
        for (FakeViewer& viewer : honest_) join(viewer);
    }
    Rude& add(milliseconds pause, int viewsAtOnce, milliseconds picture, int width, int height, std::string options)
    {
        Rude& rude = rude_.emplace_back(Rude{{},
                                             pause,
                                             picture,
                                             viewsAtOnce,
                                             width,
                                             height,
                                             std::move(options),
                                             true,
                                             false,
                                             false,
                                             now,
                                             milliseconds(0),
                                             0});
        join(rude.viewer);
        return rude;
    }
    Rude& addCostly(milliseconds picture)
    {
        return add(milliseconds(500), 1, picture, 1000, 1000, R"({"lic":{"method":"direct","steps":200}})");
    }
    Rude& addFlood() { return add(milliseconds(100), 25, kLight, 320, 240, "{}"); }

    /// A moving picture may be smaller than it was asked for, and takes less.
    static milliseconds timeOf(const Rude& rude, const DrawRequest& draw)
    {
        const OutputOptions& size = draw.scene.output;
        return rude.picture * size.width * size.height / (rude.width * rude.height);
    }

    /// How many pictures the honest viewers get. With `killEvery` the job dies that often, whatever it does.
    int simulate(milliseconds time, std::optional<milliseconds> killEvery = {})
    {
        int pictures = 0;
        std::map<const FakeViewer*, SteadyClock::time_point> looksAt;
        for (const FakeViewer& viewer : honest_) looksAt[&viewer] = now;
        const auto end = now + time;
        auto kill = killEvery ? now + *killEvery : SteadyClock::time_point::max();
        for (int step = 0; now < end; ++step, now += milliseconds(1)) {
            for (Rude& rude : rude_) {
                if (now < rude.next) continue;
                rude.next = now + rude.pause;
                for (int i = 0; i < rude.viewsAtOnce; ++i)
                    look(rude.viewer, ++number_, rude.moving, rude.options, rude.width, rude.height);
                if (rude.lies) shown(rude.viewer, 0xFFFFFFFF);
            }
            for (auto& [viewer, at] : looksAt) {
                if (now < at) continue;
                look(*viewer, ++number_, true, "{}", 320, 240);
                at = SteadyClock::time_point::max();
            }
            if (step % 100 == 0) hub.tick();
            if (now >= kill) {
                kill = now + *killEvery;
                hub.jobEnded("killed");
                draws();  // Nobody draws them any more.
                now += milliseconds(300);
                startJob();
                drawn_.reset();
                done_ = SteadyClock::time_point::max();
            }
            if (drawn_ && now >= done_) {
                const DrawRequest finished = *drawn_;
                drawn_.reset();
                tile(finished, 0, finished.scene.output.height);
                const double ms = std::chrono::duration<double, std::milli>(now - begun_).count();
                hub.jobSaid(frameEndMessage(finished.frame, Json{{"stagesMs", {{"convolve", ms}}}}.dump()));
                for (const FakeViewer& viewer : honest_)
                    if (viewer.id == finished.viewer) {
                        ++pictures;
                        shown(viewer, finished.frame);
                        looksAt[&viewer] = now + kThought;
                    }
                for (Rude& rude : rude_)
                    if (rude.viewer.id == finished.viewer) {
                        rude.had += timeOf(rude, finished);
                        ++rude.pictures;
                        shown(rude.viewer, finished.frame);
                        if (!rude.comesAgain) continue;
                        hub.leave(rude.viewer.id);
                        join(rude.viewer);
                    }
            }
            for (DrawRequest& draw : draws()) {
                EXPECT_FALSE(drawn_) << "one picture at a time";
                begun_ = now;
                done_ = now + kLight;
                for (const Rude& rude : rude_)
                    if (rude.viewer.id == draw.viewer) done_ = now + timeOf(rude, draw);
                drawn_ = std::move(draw);
            }
            for (FakeViewer& viewer : honest_) viewer.messages.clear();
            for (Rude& rude : rude_) rude.viewer.messages.clear();
        }
        return pictures;
    }

    /// What simulate(time) gives without others: every second of it is like the first ones.
    int simulateAlone(seconds time)
    {
        constexpr seconds measured(10);
        return int(simulate(measured) * (time / measured));
    }

private:
    std::uint32_t number_ = 0;
    std::optional<DrawRequest> drawn_;  // The job draws it until `done_`.
    SteadyClock::time_point begun_{}, done_ = SteadyClock::time_point::max();
    std::array<FakeViewer, kHonest> honest_;
    std::deque<Rude> rude_;
};

TEST_F(HubShares, CostlyAndManyViewsLeaveTheOthersNineTenths)
{
    const int alone = simulateAlone(seconds(60));
    const Rude& costly = addCostly(milliseconds(400));
    addFlood();
    add(milliseconds(200), 1, kLight, 320, 240, "{}");
    EXPECT_GE(simulate(seconds(60)), 0.9 * alone);
    EXPECT_GT(costly.had, milliseconds(0)) << "but it is drawn";
    EXPECT_LT(costly.had, seconds(60) / (kHonest + 1)) << "less than its share";
}

TEST_F(HubShares, SeveralCostlyViewersLeaveMostOfTheTimeToo)
{
    const int alone = simulateAlone(seconds(60));
    for (int i = 0; i < 3; ++i) addCostly(milliseconds(1000));
    EXPECT_GE(simulate(seconds(60)), 0.8 * alone);
}

/// Nothing paces a viewer whose word is not true. It looks when nobody else does.
TEST_F(HubShares, WhoSaysToHaveShownWhatWasNeverDrawnKeepsNobodyWaiting)
{
    const int alone = simulateAlone(seconds(60));
    Rude& liar = add(milliseconds(100), 1, kLight, 320, 240, "{}");
    liar.lies = true;
    add(milliseconds(100), 1, kLight, 320, 240, "{}").lies = true;
    EXPECT_GE(simulate(seconds(60)), 0.97 * alone);
    EXPECT_LT(liar.had, seconds(1));
}

TEST_F(HubTest, WhoSaysToHaveShownWhatWasNeverDrawnIsDrawnWhenNobodyElseLooks)
{
    startJob();
    FakeViewer liar;
    join(liar);
    shown(liar, 0xFFFFFFFF);
    look(liar, 1);
    EXPECT_EQ(draws().size(), 1u);
}

/// A picture that takes seconds costs the others a thirtieth of their time at most.
TEST_F(HubShares, ViewsOfManySecondsAreFarBetween)
{
    const int alone = simulateAlone(seconds(300));
    addCostly(seconds(4)).moving = false;
    EXPECT_GE(simulate(seconds(300)), 0.95 * alone);
}

/// One picture shows how long such pictures take. The next one of somebody new waits as if it had been had.
TEST_F(HubShares, WhoComesAgainForEachPictureOfManySecondsGainsNothing)
{
    const int alone = simulateAlone(seconds(300));
    Rude& rude = addCostly(seconds(4));
    rude.moving = false;
    rude.comesAgain = true;
    EXPECT_GE(simulate(seconds(300)), 0.95 * alone);
    EXPECT_GT(rude.pictures, 1) << "but it is drawn";
}

/// The time of a picture that the job did not live to finish was had, too.
TEST_F(HubShares, JobsThatDieDoNotMakeCostlyViewsFree)
{
    const int alone = simulate(seconds(60), milliseconds(3000));
    addCostly(milliseconds(2000));
    EXPECT_GE(simulate(seconds(60), milliseconds(3000)), 0.8 * alone);
}

/// A viewer that waits for a costly picture may look at light ones meanwhile.
TEST_F(HubShares, LightViewsOfWhoAskedForACostlyOneAreDrawn)
{
    simulate(seconds(1));
    Rude& one = addCostly(milliseconds(1000));
    simulate(seconds(3));
    ASSERT_GE(one.had, milliseconds(1000));
    one.width = 320, one.height = 240, one.options = "{}", one.picture = kLight;
    one.pictures = 0;
    simulate(seconds(30));
    EXPECT_GT(one.pictures, 30) << "of 60 pictures";
}

/// However long that one took: its rest pays for it, and is over when it rested.
TEST_F(HubShares, LightViewsAfterAPictureOfManySecondsAreDrawn)
{
    simulate(seconds(1));
    Rude& one = addCostly(seconds(8));
    one.moving = false;
    simulate(seconds(12));
    ASSERT_GE(one.had, seconds(8));
    one.width = 320, one.height = 240, one.options = "{}", one.picture = kLight;
    one.pictures = 0;
    simulate(seconds(60));
    EXPECT_GT(one.pictures, 60) << "of 120 pictures";
}

}  // namespace
}  // namespace aeolic::stream
