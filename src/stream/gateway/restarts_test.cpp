#include "stream/gateway/restarts.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

using namespace std::chrono_literals;

struct RestartsTest : testing::Test {
    void end(bool wasOfUse, std::chrono::seconds later = 1s) { restarts.ended(wasOfUse, now += later); }

    Restarts restarts;
    Restarts::Time now{1h};
};

TEST_F(RestartsTest, PausesGrowWhileStartsAreOfNoUse)
{
    EXPECT_EQ(restarts.pause(), 0ms);
    for (const auto pause : {250ms, 500ms, 1000ms, 2000ms, 4000ms}) {
        end(false);
        EXPECT_EQ(restarts.pause(), pause);
        EXPECT_FALSE(restarts.hopeless());
    }
    end(true);
    EXPECT_EQ(restarts.pause(), 0ms) << "a picture makes up for all before it";
}

TEST_F(RestartsTest, SixStartsWithoutAPictureAreEnough)
{
    for (int i = 0; i < Restarts::kMostInARow; ++i) {
        EXPECT_FALSE(restarts.hopeless());
        end(false, 20min);
    }
    ASSERT_TRUE(restarts.hopeless());
    EXPECT_EQ(*restarts.hopeless(), "given up after 6 starts without a picture");
}

TEST_F(RestartsTest, AJobThatDrawsAndDiesWithoutEndIsGivenUp)
{
    for (std::size_t i = 0; i < Restarts::kMostAtOnce; ++i) {
        EXPECT_FALSE(restarts.hopeless()) << i;
        end(true, 5s);
    }
    ASSERT_TRUE(restarts.hopeless());
    EXPECT_EQ(*restarts.hopeless(), "given up after 100 starts within 10 minutes");
}

TEST_F(RestartsTest, AJobThatDiesNowAndThenIsNot)
{
    for (int i = 0; i < 1000; ++i) end(true, 7s);
    EXPECT_FALSE(restarts.hopeless());
}

TEST_F(RestartsTest, WhoAsksGetsOneMoreStartAndMoreIfItIsOfUse)
{
    for (int i = 0; i < Restarts::kMostInARow; ++i) end(false);
    restarts.onceMore();
    EXPECT_FALSE(restarts.hopeless());
    end(false);
    EXPECT_TRUE(restarts.hopeless()) << "it was of no use";
    restarts.onceMore();
    end(true);
    end(false);
    EXPECT_FALSE(restarts.hopeless());
    for (std::size_t i = 0; i < Restarts::kMostAtOnce; ++i) end(true);
    restarts.onceMore();
    EXPECT_FALSE(restarts.hopeless());
}

}  // namespace
}  // namespace aeolic::stream
