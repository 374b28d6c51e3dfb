#include "cluster/guards/jump_footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/limits.h"

namespace aeolic {
namespace {

constexpr int kWidth = 160, kHeight = 320, kColumns = kWidth / JumpBoxes::kColumns;
constexpr RowSpan kStripe{152, 168}, kWhole{0, kHeight};
const Stripes kStripes{{0, 60, 152, 168, 168, 300, kHeight}};

/// Jumps of a whole image, in pixels.
struct Jumps {
    struct Jump {
        double dx = 0, dy = 0;
        bool any = false;
    };
    std::vector<Jump> all = std::vector<Jump>(std::size_t(kWidth) * std::size_t(kHeight));
    Jump& at(int x, int y) { return all[std::size_t(y) * kWidth + std::size_t(x)]; }

    template <class Of>
    explicit Jumps(const Of& of)
    {
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) at(x, y) = of(x, y);
    }
};

/// What all ranks give, by the definition.
std::vector<JumpBox> boxesOf(Jumps& jumps, float unitPx)
{
    std::vector<JumpBox> boxes;
    for (int r = 0; r < kStripes.ranks(); ++r) {
        const Extent stripe = kStripes.extent(r, kWidth);
        for (int y0 = stripe.y0; y0 < stripe.y1; y0 += JumpBoxes::kRows)
            for (int c = 0; c < kColumns; ++c) {
                JumpBox box{127, -128, 127, -128};
                for (int y = y0; y < std::min(y0 + JumpBoxes::kRows, stripe.y1); ++y)
                    for (int x = c * JumpBoxes::kColumns; x < (c + 1) * JumpBoxes::kColumns; ++x) {
                        const Jumps::Jump& jump = jumps.at(x, y);
                        if (!jump.any) continue;
                        const int dx = int(std::floor(jump.dx / unitPx)), dy = int(std::floor(jump.dy / unitPx));
                        box = {std::int8_t(std::min(int(box.x0), dx)), std::int8_t(std::max(int(box.x1), dx)),
                               std::int8_t(std::min(int(box.y0), dy)), std::int8_t(std::max(int(box.y1), dy))};
                    }
                boxes.push_back(box.empty() ? JumpBox{} : box);
            }
    }
    return boxes;
}

std::vector<RowSpan> reachedBy(Jumps jumps, int count, const RowSpan& limits = kWhole)
{
    const float unitPx = 0.5f;
    const std::vector<JumpBox> given = boxesOf(jumps, unitPx);
    return footprintOf(ImageBoxes(kStripes, {unitPx, kColumns, {}}, given, 1, 0), kStripe, limits, count);
}

Jumps uniform(double dx, double dy)
{
    return Jumps([=](int, int) { return Jumps::Jump{dx, dy, true}; });
}

TEST(JumpFootprint, WithoutJumpsAreTheStripe)
{
    for (const RowSpan& rows : reachedBy(uniform(5, 5), 0)) EXPECT_EQ(rows, kStripe);
    for (const RowSpan& rows : reachedBy(Jumps([](int, int) { return Jumps::Jump{}; }), 5)) EXPECT_EQ(rows, kStripe);
}

TEST(JumpFootprint, GoWhereTheJumpsGoAndLittleFurther)
{
    const int up = 3 * 20, beside = 3 * (limits::kJumpMarginPx + 1);
    for (const RowSpan& rows : reachedBy(uniform(0, -20), 3)) {
        EXPECT_LE(rows.y0, kStripe.y0 - up);
        EXPECT_GE(rows.y0, kStripe.y0 - up - beside - JumpFootprint::kRows);
        EXPECT_LE(rows.y1, kStripe.y1 + beside + JumpFootprint::kRows) << "not downwards";
        EXPECT_EQ(rows.y0 % JumpFootprint::kRows, 0);
    }
}

TEST(JumpFootprint, NoneBeyondTheirLimits)
{
    for (const RowSpan& rows : reachedBy(uniform(0, -20), 3, {139, 171})) EXPECT_EQ(rows, (RowSpan{139, kStripe.y1}));
    for (const RowSpan& rows : reachedBy(uniform(0, 20), 3, {139, 171})) EXPECT_EQ(rows, (RowSpan{kStripe.y0, 171}));
}

TEST(JumpFootprint, SidewaysOnlyWhereFlowLeads)
{
    // Up in one column of blocks, to the right above it, and up there.
    const std::vector<RowSpan> rows = reachedBy(Jumps([](int x, int y) {
                                                    if (x / 16 == 2 && y >= 100) return Jumps::Jump{0, -30, true};
                                                    if (y >= 120 && y < 140 && x < 64) return Jumps::Jump{30, 0, true};
                                                    if (x / 16 == 5 && y < 140) return Jumps::Jump{0, -30, true};
                                                    return Jumps::Jump{};
                                                }),
                                                4);
    EXPECT_LE(rows[2].y0, kStripe.y0 - 30);
    EXPECT_LE(rows[5].y0, 120 - 30) << "by the way through the other columns";
    for (const std::size_t c : {0u, 7u, 8u, 9u}) EXPECT_EQ(rows[c], kStripe) << "none leads there";
}

/// The trace ends as far beside the end of the nearest pixel's jump as it may, and rounding puts it into the next row.
/// Jumps are whole boxes long, and spans are not widened to whole JumpFootprint::kRows by chance: nothing is spared.
TEST(JumpFootprint, HasWhatTheFarthestTraceReads)
{
    const int lowest = 128, end = lowest + limits::kTogetherPx;
    static_assert(lowest % JumpFootprint::kRows == 0);
    for (const RowSpan& rows : reachedBy(uniform(0, end - kStripe.y0), 1)) EXPECT_LE(rows.y0, lowest - 1);
    const int last = 191, endDown = last - 1 - limits::kTogetherPx;
    static_assert((last + 1) % JumpFootprint::kRows == 0);
    for (const RowSpan& rows : reachedBy(uniform(0, endDown - (kStripe.y1 - 1)), 1)) EXPECT_GE(rows.y1, last + 1);
}

/// What the ranks give where one column of blocks has the same jump everywhere, and no other has any.
std::vector<RowSpan> reachedFromColumn(int column, double dx, double dy, float unitPx)
{
    std::vector<JumpBox> given;
    for (int r = 0; r < kStripes.ranks(); ++r) given.resize(given.size() + ImageBoxes::countOf(kStripes, r, kColumns));
    const auto units = [&](double px) { return std::int8_t(std::floor(px / double(unitPx))); };
    for (std::size_t i = std::size_t(column); i < given.size(); i += kColumns)
        given[i] = {units(dx), units(dx), units(dy), units(dy)};
    return footprintOf(ImageBoxes(kStripes, {unitPx, kColumns, {}}, given, 1, 0), kStripe, kWhole, 1);
}

/// Units that are no whole pixels are rounded to the side that is safe, and not further.
TEST(JumpFootprint, HasWhatTracesReadWhateverTheUnits)
{
    constexpr int column = 4;
    constexpr double beside = limits::kTogetherPx + 0.99;  // What is rounded is less than a pixel.
    const auto down = [](int y) { return y / JumpFootprint::kRows * JumpFootprint::kRows; };
    for (const float unitPx : {0.3f, 0.5f, 0.75f, 1.3f, 4.6f})
        for (double dy = -36; dy <= 36; dy += 0.07) {
            const RowSpan rows = reachedFromColumn(column, 0, dy, unitPx)[column];
            const double first = kStripe.y0 + dy - beside, last = kStripe.y1 - 1 + dy + beside;
            ASSERT_LE(rows.y0, std::min(kStripe.y0, int(std::floor(first)))) << dy << " in units of " << unitPx;
            ASSERT_GT(rows.y1, std::max(kStripe.y1 - 1, int(std::floor(last)) + 1)) << dy << " in units of " << unitPx;
            ASSERT_GE(rows.y0, std::min(kStripe.y0, down(int(std::floor(first - double(unitPx))) - 1)));
            ASSERT_LE(rows.y1, std::max(kStripe.y1, down(int(std::ceil(last + double(unitPx))) + 2 + 7)));
        }
}

TEST(JumpFootprint, HasTheColumnsThatTracesReadWhateverTheUnits)
{
    constexpr int column = 4, x0 = column * JumpBoxes::kColumns, x1 = x0 + JumpBoxes::kColumns - 1;
    constexpr double beside = limits::kTogetherPx + 0.99;
    for (const float unitPx : {0.3f, 0.75f, 1.3f, 4.6f})
        for (double dx = -36; dx <= 36; dx += 0.07) {
            const std::vector<RowSpan> rows = reachedFromColumn(column, dx, -30, unitPx);
            const double first = x0 + dx - beside, last = x1 + dx + beside;
            for (int c = 0; c < kColumns; ++c) {
                const int left = c * JumpBoxes::kColumns, right = left + JumpBoxes::kColumns - 1;
                const bool reached = rows[std::size_t(c)].y0 < kStripe.y0;
                if (right >= std::floor(first) && left <= std::floor(last) + 1) {
                    ASSERT_TRUE(reached) << dx << " in units of " << unitPx << ", column " << c;
                }
                if (right < first - double(unitPx) - 2 || left > last + double(unitPx) + 3) {
                    ASSERT_FALSE(reached) << dx << " in units of " << unitPx << ", column " << c;
                }
            }
        }
}

/// Traces that end up to two pixels beside where the nearest pixel's jump leads find all they read.
TEST(JumpFootprint, AreNeverTooFew)
{
    std::uint32_t random = 7;
    const auto next = [&] { return double((random = random * 1664525u + 1013904223u) >> 8) / double(1 << 24); };
    for (int round = 0; round < 20; ++round) {
        const double a = 6 * next(), b = 6 * next(), speed = 10 + 40 * next();
        Jumps jumps([&](int x, int y) {
            const double angle = std::sin(a + x * 0.03) * 3 + std::cos(b + y * 0.02) * 3;
            return Jumps::Jump{speed * std::cos(angle), speed * std::sin(angle), (x / 40 + y / 40) % 5 != 0};
        });
        const int count = 1 + round % 4;
        const std::vector<RowSpan> reached = reachedBy(jumps, count);
        for (int k = 0; k < 20000; ++k) {
            double x = std::floor(next() * kWidth), y = kStripe.y0 + std::floor(next() * 16);
            for (int hop = 0; hop < count; ++hop) {
                const int nearX = int(std::floor(x + 0.5)), nearY = int(std::floor(y + 0.5));
                if (nearX < 0 || nearX >= kWidth || nearY < 0 || nearY >= kHeight) break;
                const Jumps::Jump& jump = jumps.at(nearX, nearY);
                if (!jump.any) break;
                x = nearX + jump.dx + 4 * next() - 2;
                y = nearY + jump.dy + 4 * next() - 2;
                for (const int tapX : {int(std::floor(x)), int(std::floor(x)) + 1})
                    for (const int tapY : {int(std::floor(y)), int(std::floor(y)) + 1}) {
                        if (tapX < 0 || tapX >= kWidth || tapY < 0 || tapY >= kHeight) continue;
                        const RowSpan& rows = reached[std::size_t(tapX / JumpBoxes::kColumns)];
                        ASSERT_TRUE(tapY >= rows.y0 && tapY < rows.y1) << round << ": " << tapX << "," << tapY;
                    }
            }
        }
    }
}

}  // namespace
}  // namespace aeolic
