#include "base/text.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(Characters, LowerCaseChangesLettersOfAsciiAlone)
{
    EXPECT_EQ(lowerCase("AbZ[@`-1"), "abz[@`-1");
    EXPECT_EQ(lowerCase("\xc3\x84"), "\xc3\x84") << "a letter of two bytes";
    EXPECT_EQ(lowerCase(""), "");
}

TEST(Characters, ExtensionsAreThoseOfTheLastName)
{
    EXPECT_EQ(lowerExtension("a.b/c.VTP"), ".vtp");
    EXPECT_EQ(lowerExtension("a.b/c"), "");
    EXPECT_EQ(lowerExtension("a.vtp.series"), ".series");
    EXPECT_EQ(lowerExtension(".foam"), "") << "a hidden file";
    EXPECT_EQ(lowerExtension(""), "");
}

TEST(Characters, ControlCharactersBecomeQuestionMarks)
{
    EXPECT_EQ(withoutControls("a\nb\tc\x7f"
                              "d\x1b[1m"),
              "a?b?c?d?[1m");
    EXPECT_EQ(withoutControls("m\xc2\xb2/s\xc2\xb2"), "m\xc2\xb2/s\xc2\xb2");
}

TEST(Characters, CharactersBeginWhereTheirFirstByteIs)
{
    const std::string text =
        "a\xe2\x82\xac"
        "b";  // a, the sign of the euro in three bytes, b.
    EXPECT_EQ(characterStart(text, 1), 1u);
    EXPECT_EQ(characterStart(text, 2), 1u);
    EXPECT_EQ(characterStart(text, 3), 1u);
    EXPECT_EQ(characterStart(text, 4), 4u);
    EXPECT_EQ(characterStart(text, 5), 5u) << "the end";
    EXPECT_EQ(characterStart("\x80\x80", 1), 0u) << "no character begins";
}

}  // namespace
}  // namespace aeolic
