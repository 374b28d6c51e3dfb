#include "stream/gateway/wrong_tokens.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

using boost::asio::ip::make_address;
using std::chrono::milliseconds;

class WrongTokenWaits : public testing::Test {
protected:
    void guess(const char* from, int times = 1)
    {
        for (int i = 0; i < times; ++i) tokens.add(make_address(from), now);
    }
    milliseconds wait(const char* from) const { return tokens.waitFor(make_address(from), now); }

    WrongTokens tokens;
    WrongTokens::Clock::time_point now = WrongTokens::Clock::time_point() + std::chrono::hours(1);
};

TEST_F(WrongTokenWaits, TypingErrorsCostNothingAndGuessesMoreAndMoreUpToABound)
{
    EXPECT_EQ(wait("10.0.0.1"), milliseconds(0));
    guess("10.0.0.1", WrongTokens::kFree);
    EXPECT_EQ(wait("10.0.0.1"), milliseconds(0));
    guess("10.0.0.1");
    EXPECT_EQ(wait("10.0.0.1"), WrongTokens::kFirstWait);
    guess("10.0.0.1");
    EXPECT_EQ(wait("10.0.0.1"), 2 * WrongTokens::kFirstWait);
    guess("10.0.0.1", 100000);
    EXPECT_EQ(wait("10.0.0.1"), WrongTokens::kLongestWait);
}

TEST_F(WrongTokenWaits, OtherAddressesDoNotWait)
{
    guess("10.0.0.1", 100);
    EXPECT_EQ(wait("10.0.0.2"), milliseconds(0));
    EXPECT_EQ(wait("::1"), milliseconds(0));
}

TEST_F(WrongTokenWaits, AHostWithManyNamesOfItsOwnIsOne)
{
    guess("2001:db8::1", 50);
    guess("2001:db8::2", 50);
    EXPECT_EQ(wait("2001:db8::ffff:7"), WrongTokens::kLongestWait) << "the same network of 64 bits";
    EXPECT_EQ(wait("2001:db8:0:1::1"), milliseconds(0));
    guess("::ffff:10.0.0.1", 100);
    EXPECT_EQ(wait("10.0.0.1"), WrongTokens::kLongestWait) << "the same address, as a socket for both kinds sees it";
}

TEST_F(WrongTokenWaits, AreForgottenAfterAWhile)
{
    guess("10.0.0.1", 100);
    now += WrongTokens::kForgotten;
    EXPECT_EQ(wait("10.0.0.1"), milliseconds(0));
    guess("10.0.0.1");
    EXPECT_EQ(wait("10.0.0.1"), milliseconds(0));
}

TEST_F(WrongTokenWaits, ManyAddressesCostBoundedMemory)
{
    for (unsigned i = 0; i < 5000; ++i) {
        tokens.add(boost::asio::ip::address_v4(0x0a000000u + i), now);
        now += milliseconds(1);
    }
    EXPECT_EQ(tokens.addresses(), WrongTokens::kMostAddresses);
    guess("10.1.0.1", 100);
    EXPECT_EQ(wait("10.1.0.1"), WrongTokens::kLongestWait) << "the newest is kept";
}

}  // namespace
}  // namespace aeolic::stream
