#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic {
namespace {

TEST(InputError, IsOneLineWhateverNamesHold)
{
    EXPECT_STREQ(InputError("a.vtp", "found the array 'p\nq\r\x1b[2J'", "one of 'u\tv', 'm\xc2\xb2'\x7f").what(),
                 "a.vtp: found the array 'p q  [2J'; expected one of 'u v', 'm\xc2\xb2' ");
    EXPECT_STREQ(InputError("first\nsecond").what(), "first second");
}

TEST(InputError, NamesThingsAsWarningsDo)
{
    const std::string name = "wall\nshear\x1b\x7f" + std::string(1, '\0') + "stress";
    EXPECT_EQ(InputError(name).what(), withoutControls(name));
}

}  // namespace
}  // namespace aeolic
