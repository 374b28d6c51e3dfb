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

TEST(Characters, ControlCharactersBecomeSpaces)
{
    EXPECT_EQ(withoutControls("a\nb\tc\x7f"
                              "d\x1b[1m"),
              "a b c d [1m");
    EXPECT_EQ(withoutControls("m\xc2\xb2/s\xc2\xb2"), "m\xc2\xb2/s\xc2\xb2");
    EXPECT_EQ(withoutControls("a\nb", '?'), "a?b");
}

TEST(Characters, BlanksBecomeSpaces)
{
    EXPECT_EQ(withSpaces("a\tb\r\nc d\x1b"), "a b  c d\x1b");
}

TEST(Characters, TextIsUtf8OrNot)
{
    for (const char* text : {"", "a\n", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x8c\x80", "\xef\xbf\xbd"})
        EXPECT_TRUE(isUtf8(text)) << text;
    for (const char* text :
         {"\xe4", "a\xc3", "\xc3z", "\x80", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xff"})
        EXPECT_FALSE(isUtf8(text)) << text;
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
