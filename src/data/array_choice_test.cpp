#include "data/array_choice.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(ArrayChoice, ListsAreReadBack)
{
    const ArrayChoices arrays = arraysListed(
        "wall: shear (points, 3 components), p (cells, 1 component); on the surface: q (points, 1 component)");
    ASSERT_EQ(arrays.size(), 3u);
    EXPECT_EQ(arrays[0].name, "wall: shear");
    EXPECT_EQ(arrays[0].components, 3);
    EXPECT_EQ(arrays[1].name, "p");
    EXPECT_EQ(arrays[2].name, "q");
    EXPECT_TRUE(arraysListed("none").empty());
}

TEST(ArrayChoice, TheNearestOneAndItsLength)
{
    const ArrayChoices arrays{{"U", 3}, {"wallShearStress", 3}, {"p", 1}};
    EXPECT_EQ(nearestArray("u", arrays), "; did you mean U?");
    EXPECT_EQ(nearestArray("u:mag", arrays), "; did you mean U:mag?");
    EXPECT_EQ(nearestArray("wall_shear_stress", arrays), "; did you mean wallShearStress?");
    EXPECT_EQ(nearestArray("temperature", arrays), "");
}

}  // namespace
}  // namespace aeolic
