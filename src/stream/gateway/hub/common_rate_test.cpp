#include "stream/gateway/hub/allowance.h"

#include <gtest/gtest.h>

#include <vector>

namespace aeolic::stream {
namespace {

using Clock = CommonRate::Clock;
using std::chrono::milliseconds;

/// Connections that each take their next turn as soon as they had one, or at their own pace. Returns how many messages
/// of each come through in `time`.
std::vector<int> messagesOf(const std::vector<milliseconds>& pauses, std::chrono::seconds time)
{
    CommonRate rate;
    const Clock::time_point start = Clock::time_point() + std::chrono::hours(1);
    std::vector<Clock::time_point> due(pauses.size(), start);
    std::vector<int> count(pauses.size());
    for (;;) {
        const auto first = std::min_element(due.begin(), due.end());
        const Clock::time_point now = *first;
        if (now >= start + time) return count;
        const auto which = std::size_t(first - due.begin());
        const auto wait = rate.nextTurn(now);
        ++count[which];
        *first = now + std::max<Clock::duration>(wait + std::chrono::microseconds(1), pauses[which]);
    }
}

TEST(CommonRate, AloneNobodyWaits)
{
    CommonRate rate;
    Clock::time_point now = Clock::time_point() + std::chrono::hours(1);
    for (int i = 0; i < 1000; ++i, now += milliseconds(4)) EXPECT_EQ(rate.nextTurn(now).count(), 0);
}

TEST(CommonRate, AllTogetherGetSoManyHoweverManyTheyAre)
{
    for (const std::size_t connections : {1, 7, 256}) {
        int all = 0;
        for (const int one : messagesOf(std::vector<milliseconds>(connections), std::chrono::seconds(5))) all += one;
        EXPECT_LE(all, CommonRate::kBurst + 5 * CommonRate::kPerSecond + int(connections)) << connections;
        EXPECT_GE(all, 5 * CommonRate::kPerSecond * 9 / 10) << connections;
    }
}

TEST(CommonRate, WhoKeepsMeasureGetsThroughBesideThoseWhoDoNot)
{
    std::vector<milliseconds> pauses(63);  // As fast as they can.
    pauses.push_back(milliseconds(8));     // 125 a second.
    const auto count = messagesOf(pauses, std::chrono::seconds(5));
    EXPECT_GE(count.back(), 5 * 125 * 9 / 10);
}

}  // namespace
}  // namespace aeolic::stream
