#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
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
        return errorOf(describe(surface, field, colorBy));
    }
    static std::string errorOf(const SceneDescription& description)
    {
        try {
            loadScene(description);
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

/// U = (1 + x, 2 y, x - z) on the plane z = 1, whose normal is (0, 0, -1). Streaks see (1 + x, 2 y) of it.
TEST_F(ColorParts, ByTheNormalOfASlice)
{
    for (const char* name : {"a.vti", "a.vts", "a.vtu"}) {
        SCOPED_TRACE(name);
        const std::string file = folder_.file(name);
        writeGridFile(file);
        const Scene across = loadScene(describe("slice:0,0,1:0,0,-1", file, "U:normal"));
        EXPECT_EQ(across.ofVectors, ArrayPart::normal);
        EXPECT_EQ(across.scalarName, "U:normal");
        EXPECT_EQ(across.vectorsName, "U");
        EXPECT_NEAR(across.scalarRange[0], 0, 2e-3);
        EXPECT_NEAR(across.scalarRange[1], 2, 2e-3);
        const Scene along = loadScene(describe("slice:0,0,1:0,0,-1", file, "field:U:tangential"));
        EXPECT_EQ(along.ofVectors, ArrayPart::tangential);
        EXPECT_NEAR(along.scalarRange[1], std::hypot(2, 2.5), 5e-3);
        EXPECT_LT(along.scalarRange[0], 0.3);
        EXPECT_LE(along.robustRange[1], along.scalarRange[1]);
        EXPECT_GT(along.robustRange[1], 0.8 * along.scalarRange[1]);
    }
}

/// p rises towards (1, 10, 100).
TEST_F(ColorParts, ByTheNormalOfAnIsosurfaceAndOfABoundary)
{
    const double length = std::sqrt(1.0 + 100 + 10000);
    for (const char* name : {"a.vti", "a.vts", "a.vtu"}) {
        SCOPED_TRACE(name);
        const std::string file = folder_.file(name);
        writeGridFile(file);
        const Scene cut = loadScene(describe("isosurface:p=100", file, "U:normal"));
        // 1 + x + 20 y + 100 (x - z) at corners of the surface, where z is near 1.
        EXPECT_NEAR(cut.scalarRange[0], (1 - 1 - 10 + 100 * (-1 - 1.06)) / length, 0.05);
        EXPECT_NEAR(cut.scalarRange[1], (1 + 1 + 25 + 100 * (1 - 0.865)) / length, 0.05);
        const Scene outside = loadScene(describe("boundary", file, "U:normal"));
        EXPECT_NEAR(outside.scalarRange[0], -1 - 1.75, 0.02) << "at the top: x - z";
        EXPECT_NEAR(outside.scalarRange[1], 2 * 1.25, 0.02) << "at the back: 2 y";
    }
}

TEST_F(ColorParts, ByTheNormalOfASurfacesOwnVectors)
{
    const std::string sheet = folder_.file("sheet.vtp"), around = folder_.file("a.vti");
    writeSheetFile(sheet);
    GridSample grid;
    grid.origin = {-1, -0.5, -0.5};
    writeGridFile(around, grid);
    SceneDescription own = describe(sheet, "", "tau:normal");
    own.field.vectors = "tau";
    const Scene scene = loadScene(own);
    EXPECT_TRUE(scene.surface.pointScalars.empty());
    EXPECT_NEAR(scene.scalarRange[0], 0, 1e-6) << "tau lies in the sheet";
    EXPECT_NEAR(scene.scalarRange[1], 0, 1e-6);
    own.shading.colorBy = "tau:tangential";
    EXPECT_NEAR(loadScene(own).scalarRange[1], std::sqrt(1 + 1 + 0.01), 1e-5);
    own.field.vectors = "cellTau";
    own.shading.colorBy = "cellTau:tangential";
    EXPECT_NEAR(loadScene(own).scalarRange[0], std::sqrt(4 + 0.04), 1e-5);

    own.shading.colorBy = "tau:normal";
    EXPECT_NE(errorOf(own).find("'tau:normal' to colour by, but streaks that follow 'cellTau'; expected "
                                "'cellTau:normal'"),
              std::string::npos)
        << errorOf(own);
    EXPECT_NE(complaint(sheet, around, "surface:tau:normal").find("but no streaks that follow it"), std::string::npos);
    EXPECT_NE(complaint(sheet, around, "q:normal").find("vectors, for 'q:normal'"), std::string::npos);
    EXPECT_NE(complaint("isosurface:U:normal=1", around, "p").find("but no streaks"), std::string::npos);
}

/// The streaks follow the shear, and not what it is made of.
TEST_F(ColorParts, ByTheNormalOfWhatShearIsMadeOf)
{
    const std::string file = folder_.file("a.vtu");
    writeGridFile(file);
    SceneDescription scene = describe("boundary", file, "U:normal");
    scene.field.vectors = "wallShear(U)";
    EXPECT_NE(errorOf(scene).find("'U:normal' to colour by, but streaks that follow 'wallShear(U)'"), std::string::npos)
        << errorOf(scene);
    scene.shading.colorBy = "wallShear(U):tangential";
    const Scene shear = loadScene(scene);
    EXPECT_EQ(shear.ofVectors, ArrayPart::tangential);
    EXPECT_EQ(shear.scalarName, "wallShear(U):tangential");
    EXPECT_EQ(shear.vectorsName, "wallShear(U)");
}

/// One field on a slice, where it is sampled, and on a sheet with vectors of its own.
TEST_F(ColorParts, ByTheNormalOfSeveralSurfaces)
{
    const std::string sheet = folder_.file("sheet.vtp"), around = folder_.file("a.vti");
    writeSheetFile(sheet);
    GridSample grid;
    grid.origin = {-1, -0.5, -0.5};
    writeGridFile(around, grid);
    SceneDescription scene = describe("", around, "");
    const auto add = [&](const std::string& spec, std::optional<std::string> vectors, const std::string& colorBy) {
        SurfaceItem item;
        item.spec = spec;
        item.vectors = std::move(vectors);
        item.colorBy = colorBy;
        scene.surfaces.push_back(item);
    };
    add("slice:0,0,0.5:0,0,1", std::nullopt, "U:normal");
    add(sheet, "tau", "surface:tau:normal");
    add(sheet, "tau", "surface:q");
    const Scene joined = loadScene(scene);
    EXPECT_EQ(joined.ofVectors, ArrayPart::normal);
    EXPECT_EQ(joined.vectorsName, "") << "two names";
    EXPECT_FALSE(joined.surfaces[0].ownVectors);
    EXPECT_TRUE(joined.surfaces[1].ownVectors);
    EXPECT_FALSE(joined.surfaces[1].ownScalar);
    EXPECT_TRUE(joined.surfaces[2].ownScalar);
    scene.surfaces[0].colorBy = "p";
    EXPECT_NE(errorOf(scene).find("found 'p' of the field and ':normal' of vectors to colour by"), std::string::npos)
        << errorOf(scene);
    scene.surfaces[0].colorBy = "U:normal";
    scene.surfaces[1].colorBy = "surface:tau:tangential";
    EXPECT_NE(errorOf(scene).find("found ':normal' and ':tangential' to colour by"), std::string::npos)
        << errorOf(scene);
}

}  // namespace
}  // namespace aeolic
