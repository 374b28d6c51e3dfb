#include "stream/gateway/hub/allowance.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

using namespace std::chrono_literals;

TEST(Allowance, LetsAPageThatIsDraggedThrough)
{
    Allowance rate(kMessagesAtOnce, kMessagesPerSecond);
    auto now = std::chrono::steady_clock::now();
    for (int i = 0; i < 240 * 600; ++i) {  // Ten minutes of 120 views a second, each shown.
        now += std::chrono::microseconds(1'000'000 / 240);
        ASSERT_TRUE(rate.take(now)) << i;
    }
}

TEST(Allowance, LetsWhatANetworkHeldUpThroughAtOnce)
{
    Allowance rate(kMessagesAtOnce, kMessagesPerSecond);
    const auto now = std::chrono::steady_clock::now();
    for (int i = 0; i < int(kMessagesAtOnce) - 1; ++i) ASSERT_TRUE(rate.take(now)) << i;
}

TEST(Allowance, EndsAFlood)
{
    Allowance rate(kMessagesAtOnce, kMessagesPerSecond);
    auto now = std::chrono::steady_clock::now();
    int allowed = 0;
    while (rate.take(now) && allowed < 100000) {
        ++allowed;
        now += 1ms;  // 1000 a second: 700 more than allowed, so the burst lasts less than a second.
    }
    EXPECT_GE(allowed, 600);
    EXPECT_LE(allowed, 900);
}

TEST(Allowance, SilenceSavesUpNoMoreThanTheBurst)
{
    Allowance rate(kMessagesAtOnce, kMessagesPerSecond);
    const auto now = std::chrono::steady_clock::now() + 24h;
    int allowed = 0;
    while (rate.take(now) && allowed < 100000) ++allowed;
    EXPECT_EQ(allowed, int(kMessagesAtOnce));
}

}  // namespace
}  // namespace aeolic::stream
