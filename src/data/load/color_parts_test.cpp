#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/sample_files.h"
#include "describe_testing.h"

/// Components of vectors to colour by, and arrays that stand on points and on cells.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class ColorParts : public testing::Test {
protected:
    std::string complaint(const std::string& surface, const std::string& field, const std::string& colorBy) const
    {
        try {
            loadScene(describe(surface, field, colorBy));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    static std::array<float, 2> range(const std::vector<float>& values)
    {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        return {*least, *most};
    }

    const TempFolder folder_;
};

/// U = (1 + x, 2 y, x - z): sampled at every pixel in a uniform grid, else on the points of the cut.
TEST_F(ColorParts, ComponentsOfAField)
{
    for (const char* name : {"a.vti", "a.vts"}) {
        const std::string file = folder_.file(name);
        writeGridFile(file);
        const std::array<double, 2> expected[] = {{0, 2}, {-1, 2.5}, {-2, 0}};
        for (std::size_t k = 0; k < 3; ++k) {
            for (const char* prefix : {"", "field:", "point:", "field:point:"}) {
                const std::string by = fmt::format("{}U:{}", prefix, "xyz"[k]);
                const Scene scene = loadScene(describe("slice:0,0,1:0,0,1", file, by));
                EXPECT_EQ(scene.scalarName, fmt::format("U:{}", "xyz"[k])) << name << by;
                EXPECT_NEAR(scene.scalarRange[0], expected[k][0], 2e-3) << name << by;
                EXPECT_NEAR(scene.scalarRange[1], expected[k][1], 2e-3) << name << by;
            }
        }
    }
}

TEST_F(ColorParts, ComponentsOfASurface)
{
    const std::string sheet = folder_.file("sheet.vtp"), around = folder_.file("a.vti");
    writeSheetFile(sheet);
    GridSample grid;
    grid.origin = {-1, -0.5, -0.5};
    writeGridFile(around, grid);
    const auto scalarsOf = [&](const std::string& field, const std::string& by) {
        SceneDescription description = describe(sheet, field, by);
        if (field.empty()) description.field.vectors = "tau";
        return range(loadScene(description).surface.pointScalars);
    };
    EXPECT_EQ(scalarsOf("", "tau:x"), (std::array{1.f, 1.f}));
    EXPECT_EQ(scalarsOf("", "tau:y"), (std::array{0.f, 1.f}));
    EXPECT_EQ(scalarsOf("", "surface:cellTau:z"), (std::array{0.2f, 0.2f}));
    EXPECT_EQ(scalarsOf(around, "surface:tau:y"), (std::array{0.f, 1.f}));
}

TEST_F(ColorParts, ComponentsOfAnIsosurfaceAndOfABuiltInFlow)
{
    writeGridFile(folder_.file("a.vti"));
    const Scene cut = loadScene(describe("isosurface:U:x=1", folder_.file("a.vti"), "U:mag"));
    for (const glm::vec3& p : cut.surface.positions) EXPECT_NEAR(cut.surface.originWorld.x + double(p.x), 0, 1e-5);
    const Scene turning = loadScene(describe("plane", "rotation:16,16,16", "rotation:y"));
    ASSERT_TRUE(turning.scalarField);
    EXPECT_EQ(turning.scalarField->components, 1);
    EXPECT_NEAR(turning.scalarRange[0], -turning.scalarRange[1], 1e-5);
    EXPECT_GT(turning.scalarRange[1], 0.1);
}

TEST_F(ColorParts, ComponentsOfAWallsShear)
{
    GridSample grid;
    grid.stretch = 0.05;
    grid.origin = {0, 0, 0};
    writeGridFile(folder_.file("a.vts"), grid);
    SceneDescription description = describe("boundary", folder_.file("a.vts"), "wallShear(U):x");
    description.field.vectors = "wallShear(U)";
    const Scene scene = loadScene(description);
    EXPECT_EQ(scene.scalarName, "wallShear(U):x");
    ASSERT_EQ(scene.surface.pointScalars.size(), scene.surface.pointVectors.size());
    for (std::size_t i = 0; i < scene.surface.pointScalars.size(); ++i)
        EXPECT_EQ(scene.surface.pointScalars[i], scene.surface.pointVectors[i].x);
}

TEST_F(ColorParts, WhatHasNoSuchComponentIsRefused)
{
    writeGridFile(folder_.file("a.vti"));
    const auto refusal = [&](const std::string& by) {
        return complaint("slice:0,0,1:0,0,1", folder_.file("a.vti"), by);
    };
    EXPECT_NE(refusal("p:x").find("array 'p' has 1 component"), std::string::npos) << refusal("p:x");
    EXPECT_NE(refusal("U:w").find("did you mean U:x?"), std::string::npos) << refusal("U:w");
    EXPECT_NE(refusal("U").find("or U:mag, U:x"), std::string::npos) << refusal("U");
    EXPECT_NE(refusal("cell:p").find("no array 'cell:p'"), std::string::npos) << refusal("cell:p");
}

/// p = 1 on the points and 5 on the cell, U along x on the points and along y on the cell.
TEST_F(ColorParts, PointsOrCellsAreChosenWhereBothHaveTheName)
{
    const std::string file = folder_.file("both.vtk");
    const char* const arrays = "SCALARS p float 1\nLOOKUP_TABLE default\n";
    writeBytes(file, fmt::format("# vtk DataFile Version 3.0\nboth\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                                 "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n{0}"
                                 "1 1 1 1\nVECTORS U float\n1 0 0 1 0 0 1 0 0 1 0 0\nCELL_DATA 1\n{0}5\n"
                                 "VECTORS U float\n0 1 0\n",
                                 arrays));
    SceneDescription description = describe("slice:0,0,0.2:0,0,1", file, "");
    const auto load = [&](const std::string& vectors, const std::string& by) {
        description.field.vectors = vectors;
        description.shading.colorBy = by;
        return loadScene(description);
    };
    EXPECT_EQ(range(load("U", "p").surface.pointScalars), (std::array{1.f, 1.f}));
    EXPECT_EQ(range(load("U", "point:p").surface.pointScalars), (std::array{1.f, 1.f}));
    EXPECT_EQ(range(load("U", "cell:p").surface.pointScalars), (std::array{5.f, 5.f}));
    EXPECT_EQ(load("point:U", "p").surface.pointVectors.front(), glm::vec3(1, 0, 0));
    EXPECT_EQ(load("cell:U", "cell:U:y").surface.pointVectors.front(), glm::vec3(0, 1, 0));
    EXPECT_THROW(load("U", "cell:U:mag"), InputError) << "one name on the points alone";
}

}  // namespace
}  // namespace aeolic
