#include "data/vtk/grid/grid_arrays.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"

namespace aeolic {
namespace {

ArrayInfo array(const std::string& name, int components, bool onPoints = true)
{
    ArrayInfo info;
    info.name = name;
    info.components = components;
    info.onPoints = onPoints;
    return info;
}

const std::vector<ArrayInfo> kArrays{array("U", 3), array("p", 1), array("U", 3, false), array("q", 1, false)};

GridRequest request(const std::string& colorBy, const std::string& contour = "")
{
    GridRequest wanted;
    wanted.vectors = "U";
    wanted.colorBy = colorBy;
    if (!contour.empty()) wanted.contours = {contour};
    return wanted;
}

std::string namesOf(const std::vector<ArrayInfo>& arrays)
{
    std::string names;
    for (const ArrayInfo& a : arrays) names += a.name + (a.onPoints ? " " : "(cells) ");
    return names;
}

TEST(GridArrays, EachIsReadOnce)
{
    EXPECT_EQ(namesOf(chooseArrays(kArrays, request(""), "f").all()), "U ");
    EXPECT_EQ(namesOf(chooseArrays(kArrays, request("U:mag"), "f").all()), "U ");
    EXPECT_EQ(namesOf(chooseArrays(kArrays, request("p", "p"), "f").all()), "U p ");
    EXPECT_EQ(namesOf(chooseArrays(kArrays, request("q", "p"), "f").all()), "U q(cells) p ");
}

TEST(GridArrays, LengthOfTheVectorsIsTakenFromThem)
{
    EXPECT_EQ(chooseArrays(kArrays, request("U:mag"), "f").partOfVectors(), ArrayPart::length);
    EXPECT_EQ(chooseArrays(kArrays, request("p"), "f").partOfVectors(), ArrayPart::whole);
    EXPECT_EQ(chooseArrays(kArrays, request(""), "f").partOfVectors(), ArrayPart::whole);
    const std::vector<ArrayInfo> two{array("U", 3), array("V", 3)};
    EXPECT_EQ(chooseArrays(two, request("V:mag"), "f").partOfVectors(), ArrayPart::whole) << "of others";
}

TEST(GridArrays, WhatColoursMayBeOnTheSurfaceAndWhatIsCutMayNot)
{
    EXPECT_FALSE(chooseArrays(kArrays, request("nowhere"), "f").scalar);
    try {
        chooseArrays(kArrays, request("", "nowhere"), "f.vti");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("f.vti: no array 'nowhere' for the isosurface; expected one of: U"),
                  0u)
            << error.what();
    }
}

TEST(GridArrays, AnArrayThatIsAlmostRight)
{
    for (const auto& ask : {GridRequest{"u", "", {}}, request("", "u:MAG")}) {
        try {
            chooseArrays(kArrays, ask, "f.vti");
            FAIL();
        } catch (const InputError& error) {
            EXPECT_TRUE(std::string(error.what()).find("; did you mean U") != std::string::npos) << error.what();
        }
    }
}

TEST(GridArrays, OnTheCellsAreNotForBricks)
{
    EXPECT_NO_THROW(requirePoints(chooseArrays(kArrays, request("p"), "f").all(), "f"));
    EXPECT_THROW(requirePoints(chooseArrays(kArrays, request("q"), "f").all(), "f"), InputError);
}

}  // namespace
}  // namespace aeolic
