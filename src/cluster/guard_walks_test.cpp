// How far traces get at worst, against the guard rows that are reckoned for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cluster/guard_reach.h"
#include "render/jump_plan.h"

namespace aeolic {
namespace {

constexpr double kUnitPx = 1.0 / 2048, kMaxStepPx = 1;
constexpr int kRows = 360, kGrid = 4;  // Positions are multiples of a quarter row; the centre of row y is kGrid * y.
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

    std::vector<RowFacts> facts() const
    {
        std::vector<RowFacts> facts;
        // One unit less: it is added for rounding.
        for (const int q : quarters_) facts.push_back({0, 1, std::uint16_t(q > 0 ? q * 512 - 1 : 0)});
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

/// Calm water with rapids.
WorstTraces someTraces(std::mt19937& random)
{
    std::vector<int> quarters;
    while (quarters.size() < kRows) {
        const bool calm = random() % 3 > 0;
        const std::size_t rows = calm ? 1 + random() % 40 : 1 + random() % 8;
        const int speed = calm ? int(random() % 2) : 2 + int(random() % 3);
        quarters.insert(quarters.end(), rows, speed);
    }
    quarters.resize(kRows);
    return WorstTraces(quarters);
}

TEST(GuardWalks, NoTraceLeavesTheEstimate)
{
    std::mt19937 random(7);
    const Extent stripe{0, 170, 1, 190};
    for (const int steps : {5, 8, 24, 60, 100, 128, 203}) {
        const JumpPlan plan = planJumps(steps);
        for (int trial = 0; trial < 12; ++trial) {
            const WorstTraces traces = someTraces(random);
            const VectorReach reach(traces.facts(), kUnitPx, kMaxStepPx, plan.levels());
            const GuardRows rows = reach.rows(stripe, steps);
            EXPECT_LE(kGrid * stripe.y0 - traces.walk(plan, stripe.y0).first, kGrid * (rows.above - kTapRows))
                << steps << " steps, trial " << trial;
            EXPECT_LE(traces.walk(plan, stripe.y1 - 1).last - kGrid * (stripe.y1 - 1), kGrid * (rows.below - kTapRows))
                << steps << " steps, trial " << trial;
        }
    }
}

TEST(GuardWalks, InCalmWaterTracesGetAsFarAsTheEstimate)
{
    const WorstTraces traces(std::vector<int>(kRows, 1));
    for (const int steps : {8, 100, 128}) {
        const JumpPlan plan = planJumps(steps);
        const GuardRows rows = VectorReach(traces.facts(), kUnitPx, kMaxStepPx, 2).rows({0, 170, 1, 190}, steps);
        EXPECT_EQ(4 * 170 - traces.walk(plan, 170).first, kGrid * (rows.above - kTapRows));
    }
}

}  // namespace
}  // namespace aeolic
