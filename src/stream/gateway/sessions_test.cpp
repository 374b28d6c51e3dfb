#include "stream/gateway/sessions.h"

#include <gtest/gtest.h>

#include <set>

namespace aeolic::stream {
namespace {

TEST(Sessions, IdsAreLongPlainAndNeverTheSame)
{
    Sessions sessions;
    std::set<std::string> seen;
    for (int i = 0; i < 500; ++i) {
        const std::string id = sessions.open();
        EXPECT_GE(id.size() * 6, 128u);
        EXPECT_EQ(id.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"), id.npos);
        EXPECT_TRUE(seen.insert(id).second);
    }
}

TEST(Sessions, OnlyWholeIdsAreKnown)
{
    Sessions sessions;
    EXPECT_FALSE(sessions.knows(""));
    const std::string id = sessions.open();
    EXPECT_TRUE(sessions.knows(id));
    for (const std::string& wrong : {std::string(), id.substr(1), id + "x", std::string(id.size(), 'x')})
        EXPECT_FALSE(sessions.knows(wrong)) << wrong;
    EXPECT_FALSE(Sessions().knows(id)) << "another server's";
}

TEST(Sessions, WithoutEndTheLeastRecentlyUsedGoes)
{
    Sessions sessions;
    const std::string used = sessions.open(), forgotten = sessions.open();
    for (std::size_t i = 0; i < Sessions::kMost - 1; ++i) {
        EXPECT_TRUE(sessions.knows(used));
        sessions.open();
    }
    EXPECT_EQ(sessions.count(), Sessions::kMost);
    EXPECT_TRUE(sessions.knows(used));
    EXPECT_FALSE(sessions.knows(forgotten));
    for (int i = 0; i < 100000; ++i) sessions.open();
    EXPECT_EQ(sessions.count(), Sessions::kMost);
}

}  // namespace
}  // namespace aeolic::stream
