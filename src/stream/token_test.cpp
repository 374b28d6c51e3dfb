#include "stream/token.h"

#include <gtest/gtest.h>

#include <set>

namespace aeolic::stream {
namespace {

TEST(Token, IsLongPlainAndNeverTheSame)
{
    std::set<std::string> seen;
    std::set<char> letters;
    for (int i = 0; i < 1000; ++i) {
        const std::string token = makeToken();
        EXPECT_EQ(token.size(), 32u);
        EXPECT_EQ(token.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"),
                  token.npos);
        letters.insert(token.begin(), token.end());
        EXPECT_TRUE(seen.insert(token).second);
    }
    EXPECT_EQ(letters.size(), 64u) << "six random bits a character";
}

TEST(Token, OnlyTheWholeTokenIsTheToken)
{
    EXPECT_TRUE(sameToken("abc", "abc"));
    for (const char* wrong : {"", "a", "ab", "abcd", "abC", "Abc", "xyz"})
        EXPECT_FALSE(sameToken(wrong, "abc")) << wrong;
    EXPECT_FALSE(sameToken("abc", ""));
}

}  // namespace
}  // namespace aeolic::stream
