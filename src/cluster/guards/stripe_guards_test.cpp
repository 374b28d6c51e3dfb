#include "cluster/guards/stripe_guards.h"

#include <gtest/gtest.h>

#include <mutex>

#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

constexpr int kWidth = 21;

/// So many rows around every stripe, whatever the traces.
class FixedReach final : public GuardEstimate {
public:
    FixedReach(int above, int below) : rows_{above, below} {}
    GuardRows rows(const Extent&, int steps) const override { return {rows_.above + steps, rows_.below + steps}; }
    bool estimates() const override { return true; }

private:
    GuardRows rows_;
};

std::uint32_t wordAt(int x, int y)
{
    return std::uint32_t(1000 * y + x + 1);
}
std::uint8_t byteAt(int x, int y)
{
    return std::uint8_t(7 * y + x + 1);
}
constexpr std::uint32_t kOldWord = 0xDEADBEEF;
constexpr std::uint8_t kOldByte = 0xAB;

/// Spans of any length, among them none.
std::vector<RowFlow> someFacts(int height, int width)
{
    std::vector<RowFlow> facts(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        if (y % 4 != 2) facts[std::size_t(y)] = {std::uint16_t(y % 5), std::uint16_t(width - y % 7), 1};
    return facts;
}

bool inSpan(const RowFlow& facts, int x)
{
    return x >= facts.x0 && x < facts.x1;
}

/// The pixels with flow that `user` needs and others own.
std::int64_t pixelsNeeded(const Extent& stripe, const Extent& reached, const std::vector<RowFlow>& facts)
{
    std::int64_t pixels = 0;
    for (int y = reached.y0; y < reached.y1; ++y)
        if (y < stripe.y0 || y >= stripe.y1) pixels += facts[std::size_t(y)].x1 - facts[std::size_t(y)].x0;
    return pixels;
}

/// A word and a byte for every pixel, right in its owner's stripe; then everyone receives, and has what it needs.
void expectReceived(const Stripes& stripes, int above, int below, int steps = 0)
{
    const int height = stripes.height();
    const std::vector<RowFlow> facts = someFacts(height, kWidth);
    std::int64_t sentBytes = 0, neededBytes = 0;
    std::mutex mutex;
    runRanks(stripes.ranks(), [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const Extent stripe = stripes.extent(rank, kWidth);
        // Memory reaches further than this exchange does: rows beyond it must not change.
        const Extent valid = withGuard(stripe, {above + steps + 2, below + steps + 2}, height),
                     reached = withGuard(stripe, {above + steps, below + steps}, height);
        Image<std::uint32_t> words;
        Image<std::uint8_t> bytes;
        words.resize(valid);
        bytes.resize(valid);
        for (int y = valid.y0; y < valid.y1; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const bool right = stripe.contains(x, y) && inSpan(facts[std::size_t(y)], x);
                words.at(x, y) = right ? wordAt(x, y) : kOldWord;
                bytes.at(x, y) = right ? byteAt(x, y) : kOldByte;
            }
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<FixedReach>(above, below), facts}, room);
        EXPECT_EQ(guards.rows(steps), (GuardRows{above + steps, below + steps}));
        guards.receive({{{imageRows(words), imageRows(bytes)}, steps}});

        for (int y = valid.y0; y < valid.y1; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const bool known = inSpan(facts[std::size_t(y)], x), inside = stripe.contains(x, y);
                const bool reachedHere = reached.contains(x, y);
                ASSERT_EQ(words.at(x, y), known && reachedHere     ? wordAt(x, y)
                                          : reachedHere && !inside ? 0
                                                                   : kOldWord)
                    << "rank " << rank << " of " << stripes.ranks() << ", " << x << "," << y;
                ASSERT_EQ(bytes.at(x, y), known && reachedHere     ? byteAt(x, y)
                                          : reachedHere && !inside ? 0
                                                                   : kOldByte)
                    << "rank " << rank << " of " << stripes.ranks() << ", " << x << "," << y;
            }
        const std::lock_guard lock(mutex);
        sentBytes += communicator.sent().bytes;
        neededBytes += pixelsNeeded(stripe, reached, facts) * 5;
    });
    EXPECT_EQ(sentBytes, neededBytes) << "nothing but the pixels themselves travels";
}

TEST(StripeGuards, FromTheNeighbours)
{
    expectReceived(Stripes{{0, 10, 20}}, 4, 4);
    expectReceived(Stripes{{0, 10, 20, 30}}, 4, 3);
    expectReceived(equalStripes(61, 5), 0, 9);
}

TEST(StripeGuards, SpanningSeveralStripes)
{
    expectReceived(equalStripes(40, 8), 17, 12);
    expectReceived(equalStripes(40, 3), 1000, 1000);
}

TEST(StripeGuards, OfTheReachAskedFor)
{
    expectReceived(equalStripes(60, 4), 1, 2, 9);
}

TEST(StripeGuards, StripesOfOneRowAndEmptyOnes)
{
    expectReceived(equalStripes(7, 7), 3, 3);
    expectReceived(Stripes{{0, 0, 9, 9, 9, 10, 23, 23}}, 6, 6);
}

TEST(StripeGuards, OneRankNeedsNobody)
{
    expectReceived(Stripes{{0, 12}}, 5, 5);
}

TEST(StripeGuards, WithoutFlowNoMessageIsSent)
{
    const Stripes stripes = equalStripes(12, 3);
    runRanks(3, [&](Communicator& communicator) {
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<FixedReach>(4, 4), std::vector<RowFlow>(12)},
                            room);
        const Extent valid = withGuard(stripes.extent(communicator.rank(), kWidth), {4, 4}, 12);
        Image<std::uint32_t> words;
        words.resize(valid);
        guards.receive({{{imageRows(words)}, 0}});
        EXPECT_EQ(communicator.sent(), Traffic{});
    });
}

TEST(StripeGuards, OneMessageForEachPairThatShares)
{
    const Stripes stripes = equalStripes(30, 3);
    const std::vector<RowFlow> facts(30, RowFlow{0, kWidth, 1});
    runRanks(3, [&](Communicator& communicator) {
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<FixedReach>(5, 5), facts}, room);
        Image<std::uint32_t> words;
        words.resize(withGuard(stripes.extent(communicator.rank(), kWidth), {5, 5}, 30));
        guards.receive({{{imageRows(words)}, 0}});
        const int neighbours = communicator.rank() == 1 ? 2 : 1;
        EXPECT_EQ(communicator.sent(), (Traffic{std::int64_t(neighbours) * 5 * kWidth * 4, neighbours}));
    });
}

TEST(StripeGuards, PartsOfSeveralReachesTravelTogether)
{
    const Stripes stripes = equalStripes(40, 4);
    const std::vector<RowFlow> facts = someFacts(40, kWidth);
    runRanks(4, [&](Communicator& communicator) {
        const Extent stripe = stripes.extent(communicator.rank(), kWidth), near = withGuard(stripe, {2, 2}, 40),
                     far = withGuard(stripe, {15, 15}, 40);
        Image<std::uint32_t> words;
        Image<std::uint8_t> bytes;
        words.resize(far);
        bytes.resize(far);
        for (int y = far.y0; y < far.y1; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const bool right = stripe.contains(x, y) && inSpan(facts[std::size_t(y)], x);
                words.at(x, y) = right ? wordAt(x, y) : kOldWord;
                bytes.at(x, y) = right ? byteAt(x, y) : kOldByte;
            }
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<FixedReach>(2, 2), facts}, room);
        guards.receive({{{imageRows(words)}, 0}, {{imageRows(bytes)}, 13}});
        for (int y = far.y0; y < far.y1; ++y)
            for (int x = 0; x < kWidth; ++x) {
                if (!inSpan(facts[std::size_t(y)], x)) continue;
                ASSERT_EQ(words.at(x, y), near.contains(x, y) ? wordAt(x, y) : kOldWord) << x << "," << y;
                ASSERT_EQ(bytes.at(x, y), byteAt(x, y)) << x << "," << y;
            }
        EXPECT_EQ(communicator.sent().messages, communicator.rank() % 3 == 0 ? 2 : 3) << "one to each that reads";
    });
}

/// Jumps that all lead so many pixels up.
JumpBoxes upwards(const Extent& stripe, int width, int px)
{
    const int columns = JumpBoxes::columnsOf(width);
    const auto up = std::int8_t(-px);
    return {1.0f, columns,
            std::vector<JumpBox>(std::size_t(columns * JumpBoxes::rowsOf(stripe.height())), JumpBox{0, 0, up, up})};
}

TEST(StripeGuards, OfWhatIsReachedOnlyThatTravels)
{
    constexpr int kHeight = 120, kLimit = 40;
    const Stripes stripes = equalStripes(kHeight, 5);
    const std::vector<RowFlow> facts(kHeight, RowFlow{0, kWidth, 1});
    runRanks(5, [&](Communicator& communicator) {
        const Extent stripe = stripes.extent(communicator.rank(), kWidth),
                     valid = withGuard(stripe, {kLimit, kLimit}, kHeight);
        Image<std::uint32_t> words;
        words.resize(valid);
        for (int y = valid.y0; y < valid.y1; ++y)
            for (int x = 0; x < kWidth; ++x) words.at(x, y) = stripe.contains(x, y) ? wordAt(x, y) : kOldWord;
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<FixedReach>(kLimit, kLimit), facts}, room);
        const std::vector<JumpFootprint> reached =
            guards.reached({upwards(stripe, kWidth, 10), upwards(stripe, kWidth, 0)}, 0, 2);
        ASSERT_EQ(reached.size(), 2u);
        const std::int64_t before = communicator.received().bytes;
        guards.receive({{{imageRows(words)}, 0, &reached[0]}});
        std::int64_t pixels = 0;
        for (int y = valid.y0; y < valid.y1; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const RowSpan& rows = reached[0].rows[std::size_t(communicator.rank() * reached[0].columns + x / 16)];
                const bool right = y >= rows.y0 && y < rows.y1;
                ASSERT_EQ(words.at(x, y), right ? wordAt(x, y) : kOldWord) << x << "," << y;
                pixels += right && !stripe.contains(x, y);
            }
        EXPECT_EQ(communicator.received().bytes - before, 4 * pixels);
        const RowSpan& up = reached[0].rows[std::size_t(communicator.rank() * reached[0].columns)];
        EXPECT_LE(up.y0, std::max(stripe.y0 - 20, 0));
        EXPECT_LT(up.y1 - stripe.y1, kLimit) << "none leads downwards";
    });
}

TEST(StripeGuards, WhatIsHadIsNotSentAgain)
{
    constexpr int kHeight = 120, kHad = 5, kLimit = 40;
    const Stripes stripes = equalStripes(kHeight, 5);
    const std::vector<RowFlow> facts(kHeight, RowFlow{0, kWidth, 1});
    runRanks(5, [&](Communicator& communicator) {
        const Extent stripe = stripes.extent(communicator.rank(), kWidth),
                     had = withGuard(stripe, {kHad, kHad}, kHeight), all = withGuard(stripe, {kLimit, kLimit}, kHeight);
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<FixedReach>(0, 0), facts}, room);
        const std::vector<JumpFootprint> reached = guards.reached({upwards(stripe, kWidth, 10)}, kLimit, 2);
        for (const JumpFootprint* narrowed : {static_cast<const JumpFootprint*>(nullptr), &reached.front()}) {
            Image<std::uint32_t> words;
            words.resize(all);
            for (int y = all.y0; y < all.y1; ++y)
                for (int x = 0; x < kWidth; ++x) words.at(x, y) = stripe.contains(x, y) ? wordAt(x, y) : kOldWord;
            const std::int64_t before = communicator.received().bytes;
            guards.receive({{{imageRows(words)}, kLimit, narrowed, kHad}});
            std::int64_t pixels = 0;
            for (int y = all.y0; y < all.y1; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    const int column = communicator.rank() * reached.front().columns + x / 16;
                    const RowSpan rows = narrowed ? narrowed->rows[std::size_t(column)] : RowSpan{all.y0, all.y1};
                    const bool comes = y >= rows.y0 && y < rows.y1 && !had.contains(x, y);
                    ASSERT_EQ(words.at(x, y), comes || stripe.contains(x, y) ? wordAt(x, y) : kOldWord)
                        << x << "," << y;
                    pixels += comes;
                }
            EXPECT_TRUE(pixels > 0 || communicator.rank() == 0);  // Nothing is above the first.
            EXPECT_EQ(communicator.received().bytes - before, 4 * pixels);
        }
    });
}

TEST(StripeGuards, ByTheBoundAloneNothingIsNarrowed)
{
    const Stripes stripes = equalStripes(40, 2);
    runRanks(2, [&](Communicator& communicator) {
        Bytes room;
        StripeGuards guards(communicator, {stripes, std::make_unique<BoundReach>(1.0), std::vector<RowFlow>(40)}, room);
        const Extent stripe = stripes.extent(communicator.rank(), kWidth);
        EXPECT_TRUE(guards.reached({upwards(stripe, kWidth, 10)}, 10, 2).empty());
        EXPECT_EQ(communicator.sent(), Traffic{});
    });
}

}  // namespace
}  // namespace aeolic
