#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

const std::vector<std::string_view> kNames{"--color-by", "--colormap", "--color-range", "--steps", "--step", "--lic"};

std::string nearest(std::string_view typed)
{
    return didYouMean(typed, kNames);
}

TEST(NearestName, CaseAndDashesCountForNothing)
{
    for (const char* typed : {"--colorby", "--colorBy", "--color_by", "--COLOR-BY", "-color-by"})
        EXPECT_EQ(nearest(typed), "; did you mean --color-by?") << typed;
}

TEST(NearestName, OneFaultForThreeLetters)
{
    EXPECT_EQ(nearest("--color-ragne"), "; did you mean --color-range?") << "two letters changed places";
    EXPECT_EQ(nearest("--colr-map"), "; did you mean --colormap?") << "one is missing";
    EXPECT_EQ(nearest("--ilc"), "; did you mean --lic?");
    EXPECT_EQ(nearest("--lcx"), "") << "two faults in three letters";
    EXPECT_EQ(nearest("--nonsense"), "");
    EXPECT_EQ(nearest(""), "");
    EXPECT_EQ(nearest("--"), "");
}

TEST(NearestName, ShortNamesHaveToBeRightButForTheirCase)
{
    const std::vector<std::string> arrays{"p", "U"};
    EXPECT_EQ(didYouMean("P", arrays), "; did you mean p?");
    EXPECT_EQ(didYouMean("k", arrays), "");
}

TEST(NearestName, OfEquallyNearOnesTheOneThatBeginsSo)
{
    EXPECT_EQ(didYouMean("stepp", std::vector<std::string>{"steps", "stepPx"}), "; did you mean stepPx?");
    EXPECT_EQ(didYouMean("steqs", std::vector<std::string>{"steps", "stews"}), "; did you mean steps?");
}

TEST(NearestName, TheOnlyOneThatBeginsSo)
{
    EXPECT_EQ(didYouMean("--out", std::vector<std::string>{"--orbit", "--output"}), "; did you mean --output?");
    EXPECT_EQ(didYouMean("wall", std::vector<std::string>{"p", "wallShearStress"}), "; did you mean wallShearStress?");
    EXPECT_EQ(didYouMean("--col", std::vector<std::string>{"--color-by", "--colormap"}), "") << "which of them?";
    EXPECT_EQ(didYouMean("--ou", std::vector<std::string>{"--orbit", "--output"}), "") << "too short to tell";
}

TEST(NearestName, LongTextsAreNotCompared)
{
    const std::string text(100000, 'x');
    EXPECT_EQ(didYouMean(text, std::vector<std::string>{text + "x"}), "");
}

}  // namespace
}  // namespace aeolic
