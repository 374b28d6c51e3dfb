#include "data/load/blank_surface.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

const BlankAreas kMasked{.within = 90, .masked = 60}, kStill{.within = 90, .still = 60}, kOutside{.within = 10};

std::string adviceOn(const BlankAreas& areas, VectorsFrom from)
{
    const std::string warning = blankWarning("body", areas, 100, from);
    return warning.substr(std::min(warning.size(), warning.find("; try ")));
}

/// Who gave an offset is told to give another, not another array.
TEST(BlankSurface, AGivenOffsetIsNamedAsTheCause)
{
    for (const BlankAreas& areas : {kMasked, kStill})
        EXPECT_EQ(adviceOn(areas, VectorsFrom::fieldAtOffset), "; try another --offset, or auto");
    EXPECT_EQ(adviceOn(kOutside, VectorsFrom::fieldAtOffset),
              "; try a field around the surface, or another --offset, or auto");
    EXPECT_EQ(adviceOn(kMasked, VectorsFrom::field), "; try --vectors with another array");
    EXPECT_EQ(adviceOn(kStill, VectorsFrom::field), "; try --offset LENGTH");
    EXPECT_EQ(adviceOn(kStill, VectorsFrom::surface),
              "; try --field with the flow around it, or --vectors with the wall shear");
}

/// A slice lies where its values are.
TEST(BlankSurface, NoOffsetIsProposedForWhatIsCutOutOfTheField)
{
    EXPECT_EQ(adviceOn(kStill, VectorsFrom::cut), "; try another surface, or --vectors with another array");
    EXPECT_EQ(adviceOn(kMasked, VectorsFrom::cut), "; try --vectors with another array");
    EXPECT_EQ(adviceOn(kOutside, VectorsFrom::cut), "; try a field around the surface, or another surface");
}

TEST(BlankSurface, HalfOfItBlankIsNotToldOf)
{
    EXPECT_EQ(blankWarning("body", {.within = 100, .masked = 50}, 100, VectorsFrom::field), "");
    EXPECT_NE(blankWarning("body", {.within = 100, .masked = 51}, 100, VectorsFrom::field), "");
}

}  // namespace
}  // namespace aeolic
