#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

#include "stream/gateway/hub/hub_testing.h"

/// What others who look around keep while somebody changes the scene all the time.
namespace aeolic::stream {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::FakeViewer;

/// A job that takes its time, others who ask for their next view a moment after each picture, and one who drags.
class HubChangesBeside : public test::HubTest {
protected:
    static constexpr auto kThought = milliseconds(4);  // From a picture to the next view.
    static constexpr auto kPicture = milliseconds(20);

    struct Other {
        FakeViewer viewer;
        SteadyClock::time_point looksAt{};
        std::uint32_t view = 0;
        int pictures = 0;
    };
    struct Dragging {
        milliseconds load{60};
        int viewsAChange = 0;     ///< Its camera moves with what it changes.
        bool comesAgain = false;  ///< Under another number, for each change.
    };

    void SetUp() override
    {
        startJob();
        join(asker_);
        see(asker_, 1, false);
        next_ = now;
    }

    /// How many pictures the others get of the views that they ask for. Without `dragging` nobody changes anything.
    int picturesOfOthers(std::vector<Other>& others, milliseconds time, std::optional<Dragging> dragging = {})
    {
        for (Other& other : others) {
            if (other.viewer.id == 0) join(other.viewer);
            other.looksAt = now;
            other.pictures = 0;
        }
        changes_.clear();
        views_ = 0;
        for (const auto end = now + time; now < end; now += milliseconds(1)) {
            for (Other& other : others)
                if (now >= other.looksAt) {
                    other.looksAt = SteadyClock::time_point::max();
                    look(other.viewer, other.view = ++number_);
                }
            if (dragging) drag(*dragging);
            if (++steps_ % 100 == 0) hub.tick();
            work(others, dragging.value_or(Dragging{}));
        }
        int pictures = 0;
        for (const Other& other : others) pictures += other.pictures;
        return pictures;
    }

    /// Keeps one wish waiting, and sends views when there is another scene.
    void drag(const Dragging& how)
    {
        if (now < next_) return;
        if (views_ > 0) {
            --views_;
            look(asker_, ++number_);
        }
        if (asked_) return;
        asked_ = true;
        const std::string wish = std::to_string(++number_);
        change(asker_, R"({"surface":"slice:)" + wish + R"(,0,0:1,0,0","moving":true,"change":)" + wish + "}");
        if (how.comesAgain) next_ = now + milliseconds(1);
    }

    /// What the job does: one thing after the other.
    void work(std::vector<Other>& others, const Dragging& how)
    {
        if (load_ && now >= done_) {
            const Json loaded = *load_;
            load_.reset();
            changes_.push_back(now);
            sceneLoaded(loaded);
            views_ = how.viewsAChange;
            asked_ = false;
            next_ = now + milliseconds(2);
            if (how.comesAgain) {
                hub.leave(asker_.id);
                join(asker_);
            }
        }
        if (draw_ && now >= done_) {
            const DrawRequest drawn = *draw_;
            draw_.reset();
            finish(drawn);
            if (drawn.viewer == asker_.id) shown(asker_, drawn.frame);
            for (Other& other : others) {
                if (drawn.viewer != other.viewer.id) continue;
                shown(other.viewer, drawn.frame);
                if (drawn.view != other.view) continue;  // It waits for the one that it asked for.
                ++other.pictures;
                other.looksAt = now + kThought;
            }
        }
        for (const Json& load : loads()) load_ = load, done_ = now + how.load;
        for (const DrawRequest& draw : draws()) draw_ = draw, done_ = now + kPicture;
        for (Other& other : others) other.viewer.messages.clear();
        asker_.messages.clear();
    }

    /// From one change that is loaded to the next, in the middle of them all.
    milliseconds usualPause() const
    {
        std::vector<SteadyClock::duration> pauses;
        for (std::size_t i = 1; i < changes_.size(); ++i) pauses.push_back(changes_[i] - changes_[i - 1]);
        std::sort(pauses.begin(), pauses.end());
        return pauses.empty() ? milliseconds::max()
                              : std::chrono::duration_cast<milliseconds>(pauses[pauses.size() / 2]);
    }

    FakeViewer asker_;
    std::uint32_t number_ = 1;
    int steps_ = 0, views_ = 0;
    bool asked_ = false;
    std::optional<Json> load_;
    std::optional<DrawRequest> draw_;
    SteadyClock::time_point done_{}, next_{};
    std::vector<SteadyClock::time_point> changes_;
};

TEST_F(HubChangesBeside, TheyKeepThreeQuartersWhateverAChangeTakesAndHoweverManyViewsItBrings)
{
    for (const std::size_t count : {1u, 2u, 4u}) {
        std::vector<Other> others(count);
        const int alone = picturesOfOthers(others, seconds(30));
        for (const int loadMs : {10, 60, 400})
            for (const int views : {0, 1, 3}) {
                const int kept = picturesOfOthers(others, seconds(30), Dragging{milliseconds(loadMs), views});
                EXPECT_GE(kept, 0.75 * alone) << count << " others, loads of " << loadMs << " ms, views: " << views;
                EXPECT_LE(usualPause(), int(2 * count + 4) * (milliseconds(loadMs) + (1 + views) * kPicture))
                    << "and who drags has a share: " << count << " others, " << loadMs << " ms, views: " << views;
            }
        for (Other& other : others) hub.leave(other.viewer.id);
    }
}

TEST_F(HubChangesBeside, WhoComesAgainForEachChangeGainsNothing)
{
    std::vector<Other> others(2);
    const int alone = picturesOfOthers(others, seconds(30));
    EXPECT_GE(picturesOfOthers(others, seconds(30), Dragging{milliseconds(200), 0, true}), 0.75 * alone);
    EXPECT_GT(changes_.size(), 10u);
}

TEST_F(HubChangesBeside, APictureOfItsOwnDoesNotWaitForWhatItsChangeTook)
{
    std::vector<Other> others(2);
    picturesOfOthers(others, seconds(1));
    for (int i = 0; draw_; ++i) work(others, {}), now += milliseconds(1);
    change(asker_, R"({"surface":"slice:1,0,0:1,0,0","change":1})");
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    now += seconds(5);
    sceneLoaded(asked[0]);
    EXPECT_EQ(onlyDraw().viewer, asker_.id);
}

/// Their next view comes in a moment, and shows the new scene, too.
TEST_F(HubChangesBeside, WhoLooksAroundIsNotDrawnFromWhereItWas)
{
    std::vector<Other> others(1);
    FakeViewer& other = others[0].viewer;
    join(other);
    see(other, 7);
    change(asker_, R"({"surface":"slice:1,0,0:1,0,0","change":1})");
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    sceneLoaded(asked[0]);
    finish(onlyDraw());
    EXPECT_TRUE(draws().empty());
    look(other, 8);
    EXPECT_EQ(onlyDraw().view, 8u);
}

TEST_F(HubChangesBeside, UnlessNoViewComes)
{
    std::vector<Other> others(1);
    FakeViewer& other = others[0].viewer;
    join(other);
    see(other, 7);
    change(asker_, R"({"surface":"slice:1,0,0:1,0,0","change":1})");
    const auto asked = loads();
    ASSERT_EQ(asked.size(), 1u);
    sceneLoaded(asked[0]);
    finish(onlyDraw());
    now += Hub::kNextView;
    hub.tick();
    EXPECT_EQ(onlyDraw().view, 7u);
}

}  // namespace
}  // namespace aeolic::stream
