#include "cluster/guards/stripe_guards.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "base/image.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

constexpr int kWidth = 19;
constexpr std::uint32_t kOld = 0xDEADBEEF;

std::uint32_t wordAt(int x, int y)
{
    return std::uint32_t(1000 * y + x);
}

/// Every rank's rows are right in its stripe; after the exchange so many more on either side are, and no others.
void expectReceived(const Stripes& stripes, int rows)
{
    const int height = stripes.height();
    runRanks(stripes.ranks(), [&](Communicator& communicator) {
        const Extent stripe = stripes.extent(communicator.rank(), kWidth);
        const Extent held = withGuard(stripe, {rows + 2, rows + 2}, height),
                     right = stripe.empty() ? stripe : withGuard(stripe, {rows, rows}, height);
        Image<std::uint32_t> words;
        words.resize(held);
        for (int y = held.y0; y < held.y1; ++y)
            for (int x = 0; x < kWidth; ++x) words.at(x, y) = stripe.contains(x, y) ? wordAt(x, y) : kOld;
        StripeNeighbours(communicator, stripes).receive(imageRows(words), rows);
        for (int y = held.y0; y < held.y1; ++y)
            for (int x = 0; x < kWidth; ++x)
                ASSERT_EQ(words.at(x, y), right.contains(x, y) ? wordAt(x, y) : kOld)
                    << "rank " << communicator.rank() << ", pixel " << x << ", " << y;
    });
}

TEST(StripeNeighbours, BringRowsFromTheRankNextToAStripe)
{
    expectReceived(equalStripes(40, 3), 3);
}

TEST(StripeNeighbours, BringRowsFromSeveralRanksWhereStripesAreLow)
{
    expectReceived({{0, 1, 2, 4, 5, 12}}, 3);
}

TEST(StripeNeighbours, PassOverRanksWithoutRows)
{
    expectReceived({{0, 0, 4, 4, 4, 5, 9, 9}}, 3);
}

TEST(StripeNeighbours, OneMessageToEachNeighbour)
{
    runRanks(3, [](Communicator& communicator) {
        Image<std::uint32_t> words;
        const Stripes stripes = equalStripes(30, 3);
        words.resize(withGuard(stripes.extent(communicator.rank(), kWidth), {3, 3}, 30));
        StripeNeighbours(communicator, stripes).receive(imageRows(words), 3);
        const std::int64_t neighbours = communicator.rank() == 1 ? 2 : 1;
        EXPECT_EQ(communicator.sent(), (Traffic{neighbours * 3 * kWidth * 4, neighbours}));
    });
}

}  // namespace
}  // namespace aeolic
