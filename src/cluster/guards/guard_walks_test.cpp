// How far traces get at worst, against the guard rows that are reckoned for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cluster/guards/guard_estimate.h"
#include "render/lic/jump_plan.h"
#include "render/limits.h"

namespace aeolic {
namespace {

constexpr double kUnitPx = 1.0 / 2048, kMaxStepPx = 1 / limits::kRounded;  // One pixel, rounding included.
constexpr int kRows = 480, kGrid = 4;  // Positions are multiples of a quarter row; the centre of row y is kGrid * y.
constexpr int kFarthestSample = 2 * kGrid;  // From where the step begins; from where it ends, three.

/// Where a trace may be, anywhere between.
struct Between {
    int first, last;
};

/// How far it may get from somewhere, upwards and downwards.
struct Ways {
    int up = 0, down = 0;
};

/// Traces that do the worst they may. Rows have speeds of so many quarters of a pixel a step; a step goes as fast as
/// any vector it may have sampled, and a jump that starts between rows as far as that of either.
class WorstTraces {
public:
    explicit WorstTraces(std::vector<int> quarters) : quarters_(std::move(quarters)) {}

    std::vector<RowFlow> facts() const
    {
        std::vector<RowFlow> facts;
        // So many units that they are no fewer after the allowance for rounding is added.
        for (const int q : quarters_) {
            const double units = std::ceil((q * 512 - 1) / limits::kRounded);
            facts.push_back({0, std::uint16_t(q > 0), std::uint16_t(q > 0 ? units : 0)});
        }
        return facts;
    }

    /// Where one from the centre of that row may have got by all steps of the plan.
    Between walk(const JumpPlan& plan, int row) const
    {
        std::vector<std::vector<Ways>> levels{walked(plan.direct)};
        for (const int radix : plan.radix) levels.push_back(joined(levels.back(), radix));
        Between at{kGrid * row, kGrid * row};
        bool onPixel = true;
        for (std::size_t i = levels.size(); i-- > 0;)
            for (int k = 0; k < plan.digits[i]; ++k, onPixel = false) at = jump(levels[i], at, onPixel);
        if (plan.remainder > 0) at = jump(walked(plan.remainder), at, onPixel);
        return at;
    }

private:
    int speedAround(int at) const
    {
        int most = 0;  // A vector between rows is of both.
        for (int y = 0; y < kRows; ++y)
            if (std::abs(kGrid * y - at) < kFarthestSample + kGrid) most = std::max(most, quarters_[std::size_t(y)]);
        return most;
    }

    template <class WaysAt>
    static Between next(const Between& from, const WaysAt& waysAt)
    {
        Between to = from;
        for (int at = from.first; at <= from.last; ++at) {
            const Ways ways = waysAt(at);
            to.first = std::min(to.first, at - ways.up);
            to.last = std::max(to.last, at + ways.down);
        }
        return {std::max(to.first, 0), std::min(to.last, kGrid * (kRows - 1))};
    }

    static Between jump(const std::vector<Ways>& level, const Between& from, bool onPixel)
    {
        return next(from, [&](int at) {
            const Ways &a = level[std::size_t(at / kGrid)],
                       &b = onPixel ? a : level[std::size_t((at + kGrid - 1) / kGrid)];
            return Ways{std::max(a.up, b.up), std::max(a.down, b.down)};
        });
    }

    template <class Walk>
    static std::vector<Ways> ofEachRow(const Walk& walk)
    {
        std::vector<Ways> ways;
        for (int y = 0; y < kRows; ++y) {
            const Between at = walk(Between{kGrid * y, kGrid * y});
            ways.push_back({kGrid * y - at.first, at.last - kGrid * y});
        }
        return ways;
    }

    std::vector<Ways> walked(int steps) const
    {
        return ofEachRow([&](Between at) {
            for (int i = 0; i < steps; ++i)
                at = next(at, [&](int p) {
                    const int speed = speedAround(p);
                    return Ways{speed, speed};
                });
            return at;
        });
    }

    static std::vector<Ways> joined(const std::vector<Ways>& lower, int radix)
    {
        return ofEachRow([&](Between at) {
            for (int k = 0; k < radix; ++k) at = jump(lower, at, k == 0);
            return at;
        });
    }

    std::vector<int> quarters_;  // [kRows]
};

/// Calm water with rapids, and rocks; the longer the traces, the calmer.
WorstTraces someTraces(std::mt19937& random, int steps)
{
    std::vector<int> quarters;
    while (quarters.size() < kRows) {
        const bool calm = int(random() % 96) > 3200 / steps;
        const std::size_t rows = calm ? 1 + random() % 40 : 1 + random() % 8;
        const int speed = calm ? int(random() % 2) : 2 + int(random() % 3);
        quarters.insert(quarters.end(), rows, speed);
    }
    quarters.resize(kRows);
    return WorstTraces(quarters);
}

/// Rows that the worst of traces lack above and below a stripe, in quarters; negative: so many are left over.
int lacking(const WorstTraces& traces, const JumpPlan& plan, int levels)
{
    const Extent stripe{0, kRows / 2 - 10, 1, kRows / 2 + 10};
    const GuardRows rows = VectorReach(traces.facts(), kUnitPx, kMaxStepPx, levels).rows(stripe, plan.steps());
    const Between up = traces.walk(plan, stripe.y0), down = traces.walk(plan, stripe.y1 - 1);
    return std::max(kGrid * (stripe.y0 - (rows.above - limits::kTapRows)) - up.first,
                    down.last - kGrid * (stripe.y1 - 1 + (rows.below - limits::kTapRows)));
}

constexpr int kManySteps[] = {5, 8, 24, 60, 100, 128, 203, 300, 512, 1024};  // One to four levels.

TEST(GuardWalks, NoTraceLeavesTheEstimate)
{
    std::mt19937 random(7);
    for (const int steps : kManySteps) {
        const JumpPlan plan = planJumps(steps);
        for (int trial = 0; trial < 12; ++trial)
            EXPECT_LE(lacking(someTraces(random, steps), plan, plan.levels()), 0) << steps << " steps, trial " << trial;
    }
}

TEST(GuardWalks, TracesMadeOfJumpsLeaveAnEstimateThatLooksAroundLess)
{
    std::mt19937 random(7);
    for (const int steps : kManySteps) {
        const JumpPlan plan = planJumps(steps);
        if (plan.levels() < 2) continue;  // A jump of the only level begins on a pixel.
        int most = -kRows * kGrid;
        for (int trial = 0; trial < 60; ++trial) most = std::max(most, lacking(someTraces(random, steps), plan, 1));
        EXPECT_GT(most, 0) << steps << " steps";
    }
}

TEST(GuardWalks, InCalmWaterTracesGetAsFarAsTheEstimate)
{
    const WorstTraces traces(std::vector<int>(kRows, 1));
    for (const int steps : {8, 100, 128, 300}) {
        EXPECT_LE(lacking(traces, planJumps(steps), 3), 0) << steps;
        EXPECT_GE(lacking(traces, planJumps(steps), 3), -kGrid) << steps;
    }
}

/// In uniform flow of so many pixels a step downwards: how many rows below a pixel are read for its value, where the
/// pixels it looks jumps up at have to walk them, too.
int rowsReadBelow(const JumpPlan& plan, double stepPx)
{
    const auto after = [&](int steps) { return int(std::floor(steps * stepPx)); };
    const auto walk = [&](int steps) { return after(steps) + 2; };  // A tap, whose noise is sharpened by the next row.
    std::vector<int> ofLevel{walk(plan.direct)};
    for (std::size_t i = 0; i < plan.radix.size(); ++i)
        ofLevel.push_back(after((plan.radix[i] - 1) * plan.stride(i)) + 1 + ofLevel[i]);
    int most = 0, walked = 0;
    for (std::size_t i = plan.digits.size(); i-- > 0;)
        for (int k = 0; k < plan.digits[i]; ++k, walked += plan.stride(i))
            most = std::max(most, after(walked) + (walked > 0) + ofLevel[i]);
    return plan.remainder > 0 ? std::max(most, after(walked) + 1 + walk(plan.remainder)) : most;
}

TEST(GuardWalks, GuardsDrawnAgainHaveWhatTheirOwnJumpsRead)
{
    for (const int steps : {8, 100, 128, 640, 768, 1024, 3840, 20480})
        for (const double px : {0.02122, 0.12509, 0.38047, 0.5, 0.625028, 0.77, 0.999, 1.0, 1.3}) {
            const JumpPlan plan = planJumps(steps);
            EXPECT_LE(rowsReadBelow(plan, px), guardRowsBound(steps, px, plan.levels())) << steps << " of " << px;
        }
}

}  // namespace
}  // namespace aeolic
