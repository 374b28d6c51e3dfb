#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"

/// Which array a surface is coloured by: its own or the field's.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

TEST(ColorBy, GridScalarIsRangedOverTheSurface)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    const Scene scene = loadScene(describe("slice:0,0,1:0,0,1", folder.file("a.vti"), "p"));
    ASSERT_TRUE(scene.hasScalar);
    ASSERT_TRUE(scene.scalarField);
    EXPECT_EQ(scene.scalarName, "p");
    EXPECT_EQ(scene.scalarField->components, 1);
    EXPECT_NEAR(scene.scalarRange[0], -1 - 5 + 100, 0.01);
    EXPECT_NEAR(scene.scalarRange[1], 1 + 12.5 + 100, 0.01);
}

TEST(ColorBy, LengthOfTheFieldsVectorsNeedsNoScalarField)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vti"));
    const Scene scene = loadScene(describe("slice:0,0,1:0,0,1", folder.file("a.vti"), "U:mag"));
    EXPECT_EQ(scene.ofVectors, ArrayPart::length);
    EXPECT_FALSE(scene.scalarField);
    EXPECT_EQ(scene.scalarName, "|U|");
    EXPECT_NEAR(scene.scalarRange[1], std::sqrt(4 + 6.25 + 0), 0.01);
}

/// A triangle within the box of the sample grids, with p = 7 on its points and U of length 5 on its cell.
void writeTriangle(const std::string& path)
{
    writeBytes(path, R"(# vtk DataFile Version 3.0
a triangle
ASCII
DATASET POLYDATA
POINTS 3 float
0 0 0.5 0.5 0 0.5 0 0.5 0.5
POLYGONS 1 4
3 0 1 2
CELL_DATA 1
VECTORS U float
3 4 0
POINT_DATA 3
SCALARS p float 1
LOOKUP_TABLE default
7 7 7
)");
}

class ColorBySource : public testing::Test {
protected:
    ColorBySource()
    {
        writeTriangle(folder_.file("s.vtk"));
        GridSample around;
        around.origin = {-1, -0.5, -0.5};
        writeGridFile(folder_.file("a.vti"), around);
    }
    Scene load(const std::string& colorBy, bool withField = true) const
    {
        return loadScene(describe(folder_.file("s.vtk"), withField ? folder_.file("a.vti") : "", colorBy));
    }
    std::string error(const std::string& colorBy, bool withField = true) const
    {
        try {
            load(colorBy, withField);
        } catch (const InputError& wrong) {
            return wrong.what();
        }
        return "";
    }
    static void expectHas(const std::string& text, const std::string& part)
    {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
    }

private:
    const TempFolder folder_;
};

TEST_F(ColorBySource, WhatHasTheVectorsComesFirst)
{
    const Scene both = load("p");
    EXPECT_TRUE(both.scalarField);
    EXPECT_TRUE(both.surface.pointScalars.empty());
    EXPECT_GT(both.scalarRange[1], 20);
    EXPECT_EQ(load("U:mag").ofVectors, ArrayPart::length);
    EXPECT_EQ(load("p", false).scalarRange, (std::array<double, 2>{7, 7}));
}

TEST_F(ColorBySource, ThePrefixChooses)
{
    const Scene own = load("surface:p");
    EXPECT_FALSE(own.scalarField);
    EXPECT_EQ(own.scalarRange, (std::array<double, 2>{7, 7}));
    EXPECT_EQ(own.scalarName, "p");
    EXPECT_EQ(load("surface:U:mag").scalarRange, (std::array<double, 2>{5, 5}));
    EXPECT_TRUE(load("field:p").scalarField);
    EXPECT_EQ(load("field:U:mag").ofVectors, ArrayPart::length);
    EXPECT_EQ(load("surface:p", false).scalarRange, (std::array<double, 2>{7, 7}));
}

TEST_F(ColorBySource, TheOtherIsTakenWhereTheFirstHasNone)
{
    const TempFolder folder;
    writeSheetFile(folder.file("s.vtp"));
    GridSample around;
    around.origin = {-1, -0.5, -0.5};
    writeGridFile(folder.file("a.vti"), around);
    const Scene own = loadScene(describe(folder.file("s.vtp"), folder.file("a.vti"), "q"));
    EXPECT_EQ(own.surface.pointScalars.size(), own.surface.positions.size());
    EXPECT_FALSE(own.scalarField);
    EXPECT_EQ(own.scalarRange, (std::array<double, 2>{0, 2}));
    EXPECT_THROW(loadScene(describe(folder.file("s.vtp"), folder.file("a.vti"), "field:q")), InputError);
    EXPECT_THROW(loadScene(describe(folder.file("s.vtp"), "abc", "surface:abc:mag")), InputError);
    EXPECT_EQ(loadScene(describe(folder.file("s.vtp"), "abc", "field:abc:mag")).ofVectors, ArrayPart::length);
    EXPECT_EQ(loadScene(describe(folder.file("s.vtp"), "abc", "q")).scalarRange, (std::array<double, 2>{0, 2}));
}

TEST_F(ColorBySource, ErrorsNameBothListsAndTheNearestName)
{
    for (const char* typed : {"pp", "surface:pp", "field:pp", "surface:", "field:"}) {
        const std::string text = error(typed);
        expectHas(text, std::string("'") + typed + "'");
        expectHas(text, "p (points, 1 component)");
        expectHas(text, "on the surface: p (points, 1 component), U (cells, 3 components)");
    }
    expectHas(error("surface:U:magg"), "did you mean surface:U:mag?");
    expectHas(error("field:U:magg"), "did you mean field:U:mag?");
    expectHas(error("U:magg"), "did you mean U:mag?");
    expectHas(error("field:p", false), "'field:p'");
    expectHas(error("field:p", false), "p (points, 1 component), U (cells, 3 components)");
}

}  // namespace
}  // namespace aeolic
