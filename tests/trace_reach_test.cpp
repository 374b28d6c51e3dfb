#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cluster/guards/guard_estimate.h"
#include "render/gbuffer.h"
#include "render/lic/jump_plan.h"

/// Compares guard rows estimated from the vectors with traces that are really walked. One column of pixels is enough,
/// because only the largest displacement of each row counts.
namespace aeolic {
namespace {

/// A column of flow, and how far traces get in it. They are walked in double precision, and a turning flow does not end
/// them, so they go at least as far as the program's.
class Column {
public:
    Column(std::vector<int> units, std::vector<bool> flows, double unitPx)
        : units_(std::move(units)), flows_(std::move(flows)), unitPx_(unitPx)
    {
    }

    int height() const { return int(units_.size()); }
    bool flowsAt(int row) const { return row >= 0 && row < height() && flows_[std::size_t(row)]; }

    std::vector<RowFlow> facts() const
    {
        std::vector<RowFlow> facts(units_.size());
        for (std::size_t y = 0; y < units_.size(); ++y)
            if (flows_[y]) facts[y] = {0, 1, std::uint16_t(std::abs(units_[y]))};
        return facts;
    }

    double displacementPx(int row) const { return units_[std::size_t(row)] * unitPx_; }

private:
    std::vector<int> units_;
    std::vector<bool> flows_;
    double unitPx_;
};

/// First and last row that was read.
struct RowsRead {
    int first = 1 << 30, last = -1;
    void add(int row)
    {
        first = std::min(first, row);
        last = std::max(last, row);
    }
};

/// Interpolates `of(row)` between the rows that have flow. False where the nearest row has none or lies outside.
template <class Of>
bool interpolate(const Column& column, double y, const Of& of, double& value, RowsRead& rows)
{
    const int upper = int(std::floor(y));
    const double weight = y - upper;
    rows.add(upper);
    rows.add(upper + 1);
    if (!column.flowsAt(weight < 0.5 ? upper : upper + 1)) return false;
    const double a = column.flowsAt(upper) ? 1 - weight : 0, b = column.flowsAt(upper + 1) ? weight : 0;
    value = ((a > 0 ? a * of(upper) : 0) + (b > 0 ? b * of(upper + 1) : 0)) / (a + b);
    return true;
}

/// Second-order steps from pixel `row`, `doubled` as the hierarchical method begins. Returns the displacement.
double walk(const Column& column, int row, int steps, int sign, bool doubled, RowsRead& rows)
{
    double y = row, v = 0;
    const auto flow = [&](int r) { return sign * column.displacementPx(r); };
    for (int done = 0; done < steps;) {
        const int length = doubled && done + 2 <= steps ? 2 : 1;
        if (!interpolate(column, y, flow, v, rows)) break;
        if (!interpolate(column, y + 0.5 * length * v, flow, v, rows)) break;
        y += length * v;
        done += length;
    }
    interpolate(column, y, flow, v, rows);
    return y - row;
}

Column randomColumn(std::mt19937& random, double unitPx)
{
    const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); };
    const int height = pick(120, 260);
    std::vector<int> units;
    std::vector<bool> flows;
    while (int(units.size()) < height) {
        // Calm water, rapids, rocks, and everything between them, in bands of any thickness.
        const int kind = pick(0, 9), rows = pick(1, kind < 3 ? 40 : 12);
        const int sign = pick(0, 9) == 0 ? -1 : 1;
        for (int i = 0; i < rows; ++i) {
            const int fastest = flow_texel::kDisplacementMax;
            const int speed = kind < 3   ? pick(0, 12)
                              : kind < 6 ? pick(fastest - 200, fastest)
                              : kind < 9 ? fastest * (i + 1) / rows
                                         : 0;
            units.push_back(sign * speed);
            flows.push_back(kind != 9 || pick(0, 5) == 0);
        }
    }
    units.resize(std::size_t(height));
    flows.resize(std::size_t(height));
    return {std::move(units), std::move(flows), unitPx};
}

void expectWithin(const RowsRead& rows, const Extent& stripe, const GuardRows& guard, const Column& column,
                  const std::string& what)
{
    if (rows.last < rows.first) return;
    const Extent valid = withGuard(stripe, guard, column.height());
    EXPECT_GE(std::max(rows.first, 0), valid.y0) << what << ", stripe " << stripe.y0 << " to " << stripe.y1;
    EXPECT_LE(std::min(rows.last, column.height() - 1), valid.y1 - 1)
        << what << ", stripe " << stripe.y0 << " to " << stripe.y1;
}

/// Every longest step, with its unit as the program chooses it.
template <class Body>
void forManyColumns(const Body& body)
{
    std::mt19937 random(7);
    for (const double maxStepPx : {0.25, 1.0, 2.5, 8.0}) {
        const double unitPx = std::exp2(std::ceil(std::log2(maxStepPx))) / (flow_texel::kDisplacementMax + 1);
        for (int i = 0; i < 40; ++i) {
            Column column = randomColumn(random, maxStepPx / (flow_texel::kDisplacementMax + 1));
            const int y0 = std::uniform_int_distribution<int>(0, column.height() - 1)(random);
            const int y1 = std::uniform_int_distribution<int>(y0 + 1, std::min(y0 + 30, column.height()))(random);
            // The program's larger unit rounds the speeds. The estimate must cover that, too.
            std::vector<RowFlow> facts = column.facts();
            for (RowFlow& row : facts)
                row.maxUnits = std::uint16_t(std::floor(row.maxUnits * maxStepPx / 2048 / unitPx + 0.5));
            const auto vectors = [&](int levels) { return VectorReach(facts, unitPx, maxStepPx, levels); };
            body(column, vectors, maxStepPx, Extent{0, y0, 1, y1});
        }
    }
}

TEST(TraceReach, DirectTracesStayWithinTheEstimateAndItWithinTheBound)
{
    forManyColumns([](const Column& column, const auto& vectors, double maxStepPx, const Extent& stripe) {
        for (const int steps : {1, 7, 60}) {
            const GuardRows guard = vectors(0).rows(stripe, steps), bound = BoundReach(maxStepPx).rows(stripe, steps);
            EXPECT_LE(guard.above, bound.above);
            EXPECT_LE(guard.below, bound.below);
            RowsRead rows;
            for (int y = stripe.y0; y < stripe.y1; ++y)
                for (const int sign : {-1, 1}) walk(column, y, steps, sign, false, rows);
            expectWithin(rows, stripe, guard, column, std::to_string(steps) + " steps");
        }
    });
}

/// The jumps of each level, as each pixel has them.
std::vector<std::vector<double>> jumpsOf(const Column& column, const JumpPlan& plan, int sign)
{
    std::vector<std::vector<double>> levels(1);
    RowsRead ignored;
    for (int y = 0; y < column.height(); ++y) levels[0].push_back(walk(column, y, plan.direct, sign, true, ignored));
    for (const int radix : plan.radix) {
        const std::vector<double> below = levels.back();
        levels.emplace_back();
        for (int row = 0; row < column.height(); ++row) {
            double y = row;
            for (int j = 0; j < radix; ++j) {
                double jump = 0;
                if (!interpolate(
                        column, y, [&](int r) { return below[std::size_t(r)]; }, jump, ignored))
                    break;
                y += jump;
            }
            levels.back().push_back(y - row);
        }
    }
    return levels;
}

/// How far each level of jumps is read: when the next level is joined, and in the end.
TEST(TraceReach, EveryLookUpOfAJumpStaysWithinItsLevelsReach)
{
    forManyColumns([](const Column& column, const auto& vectors, double maxStepPx, const Extent& stripe) {
        for (const int steps : {8, 37, 128, 200}) {
            const JumpPlan plan = planJumps(steps);
            const VectorReach estimate = vectors(plan.levels());
            for (const int sign : {-1, 1}) {
                const auto levels = jumpsOf(column, plan, sign);
                std::vector<RowsRead> rows(levels.size());
                RowsRead remainder;
                const auto jump = [&](double& y, std::size_t level) {
                    double by = 0;
                    const bool goes = interpolate(
                        column, y, [&](int r) { return levels[level][std::size_t(r)]; }, by, rows[level]);
                    y += goes ? by : 0;
                    return goes;
                };
                for (int row = stripe.y0; row < stripe.y1; ++row) {
                    if (!column.flowsAt(row)) continue;
                    for (std::size_t level = 0; level < plan.radix.size(); ++level) {
                        double y = row;
                        for (int j = 0; j < plan.radix[level] && jump(y, level); ++j) {
                        }
                    }
                    double y = row;
                    bool goes = true;
                    for (std::size_t level = levels.size(); level-- > 0;)
                        for (int k = 0; k < plan.digits[level] && goes; ++k) goes = jump(y, level);
                    if (goes && plan.remainder > 0) {
                        remainder.add(int(std::floor(y)));
                        remainder.add(int(std::floor(y)) + 1);
                    }
                }
                for (std::size_t level = 0; level < levels.size(); ++level) {
                    const int reach = plan.levelReach(level);
                    const std::string what = "level " + std::to_string(level) + " of " + std::to_string(steps);
                    expectWithin(rows[level], stripe, estimate.rows(stripe, reach), column, what);
                    expectWithin(rows[level], stripe, BoundReach(maxStepPx).rows(stripe, reach), column,
                                 what + ", bound");
                }
                expectWithin(remainder, stripe, estimate.rows(stripe, plan.remainderReach()), column, "the remainder");
            }
        }
    });
}

}  // namespace
}  // namespace aeolic
