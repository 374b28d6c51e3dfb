#include "stream/gateway/hub/request_rate.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

using namespace std::chrono_literals;

TEST(RequestRate, LetsAPageThatIsDraggedThrough)
{
    RequestRate rate;
    auto now = std::chrono::steady_clock::now();
    for (int i = 0; i < 240 * 600; ++i) {  // Ten minutes of 120 views a second, each shown.
        now += std::chrono::microseconds(1'000'000 / 240);
        ASSERT_TRUE(rate.allows(now)) << i;
    }
}

TEST(RequestRate, LetsWhatANetworkHeldUpThroughAtOnce)
{
    RequestRate rate;
    const auto now = std::chrono::steady_clock::now();
    for (int i = 0; i < RequestRate::kBurst - 1; ++i) ASSERT_TRUE(rate.allows(now)) << i;
}

TEST(RequestRate, EndsAFlood)
{
    RequestRate rate;
    auto now = std::chrono::steady_clock::now();
    int allowed = 0;
    while (rate.allows(now) && allowed < 100000) {
        ++allowed;
        now += 1ms;  // 1000 a second: 700 more than allowed, so the burst lasts less than a second.
    }
    EXPECT_GE(allowed, 600);
    EXPECT_LE(allowed, 900);
}

TEST(RequestRate, SilenceSavesUpNoMoreThanTheBurst)
{
    RequestRate rate;
    const auto now = std::chrono::steady_clock::now() + 24h;
    int allowed = 0;
    while (rate.allows(now) && allowed < 100000) ++allowed;
    EXPECT_EQ(allowed, int(RequestRate::kBurst));
}

}  // namespace
}  // namespace aeolic::stream
