#include "stream/gateway/last_words.h"

#include <gtest/gtest.h>

namespace aeolic::stream {
namespace {

TEST(LastWords, AreTheLastLinesThatSaySomething)
{
    EXPECT_EQ(lastWords(""), "");
    EXPECT_EQ(lastWords("\n \t\n"), "");
    EXPECT_EQ(lastWords("srun: error: no nodes\n\n"), "srun: error: no nodes");
    EXPECT_EQ(lastWords("one\ntwo\r\nthree\n  four\x1b[0m"), "two three four [0m");
    const std::string shortened = lastWords(std::string(5000, 'x'));
    EXPECT_TRUE(shortened.starts_with("xxx") && shortened.ends_with("x …"));
    EXPECT_EQ(shortened.find(' '), 400u);
}

TEST(LastWords, OfAMessageBetweenRulersAreItsBeginning)
{
    const std::string ruler(74, '-');
    EXPECT_EQ(lastWords("noise\n" + ruler +
                        "\nThere are not enough slots\nfor the 4\n\nthat were asked for.\nAdvice.\n" + ruler + "\n"),
              "There are not enough slots for the 4 that were asked for.");
    EXPECT_EQ(lastWords("why\n" + ruler + "\n"), "why") << "one ruler alone";
    EXPECT_EQ(lastWords(ruler + "\nadvice\n" + ruler + "\nrank 1 was killed"), "advice rank 1 was killed");
    EXPECT_EQ(lastWords(ruler + "\n" + ruler), "");
}

}  // namespace
}  // namespace aeolic::stream
