#include <gtest/gtest.h>
#include <vtkExodusIIWriter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "part_formats_testing.h"
#include "reader/exodus/exodus_blocks.h"
#include "reader/exodus/testing/sample_exodus.h"

/// Exodus files that are sound. Damaged ones: exodus_damaged_test.cpp.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Form = SampleExodus::Form;

constexpr std::size_t kQuads = 16;  // Of each side of the box.
constexpr Form allForms[] = {Form::classic, Form::offsets64, Form::data64, Form::netcdf4};

class Exodus : public testing::Test {
protected:
    void write(const SampleExodus& sample = {}) const { writeSampleExodus(file_, sample); }

    static SceneDescription describe(const std::string& surface, const std::string& field = "",
                                     const std::string& colorBy = "", bool steps = false)
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.surface.cells = steps ? CellValues::steps : CellValues::smooth;
        description.field.spec = field;
        description.field.vectors = "vel";
        description.shading.colorBy = colorBy;
        return description;
    }

    TempFolder folder_;
    std::string file_ = folder_.file("box.e");
};

void expectFlow(const Scene& scene, double step = 0, double shift = 0)
{
    testkit::expectVectors(
        scene, [&](const glm::dvec3& p) { return exodusFlow(p - glm::dvec3(0, 0, shift)) + glm::dvec3(step, 0, 0); });
}

TEST_F(Exodus, SideSetsAreTheSurfaceUnlessAPartIsNamed)
{
    for (const Form form : allForms)
        for (const bool doubles : {true, false}) {
            write({.form = form, .doubles = doubles});
            const Scene all = loadScene(describe(file_));
            EXPECT_EQ(all.surface.triangles.size(), 3 * 2 * kQuads);
            expectFlow(all);
            for (const char* name : {":floor", ":sideset_100", ":fl*"})
                EXPECT_EQ(loadScene(describe(file_ + name)).surface.triangles.size(), 2 * kQuads) << name;
            const Scene low = loadScene(describe(file_ + ":low"));
            EXPECT_NEAR(areaOf(low.surface), 2 * 16 + 4 * 8, 1e-5);
            expectFlow(low);
        }
}

TEST_F(Exodus, EveryFormOfNetcdfGivesTheSameBytes)
{
    for (const char* part : {":floor", ":lid,inlet", ":high"}) {
        std::vector<std::string> found;
        for (const Form form : allForms) {
            write({.form = form});
            found.push_back(fingerprint(loadScene(describe(file_ + part, "", "pressure"))));
        }
        EXPECT_EQ(found, std::vector<std::string>(found.size(), found[0])) << part;
    }
}

TEST_F(Exodus, PartsWithoutNamesHaveNumbers)
{
    write({.names = false});
    EXPECT_EQ(loadScene(describe(file_ + ":sideset_101")).surface.triangles.size(), 2 * kQuads);
    EXPECT_NEAR(areaOf(loadScene(describe(file_ + ":block_10")).surface), 2 * 16 + 4 * 8, 1e-5);
}

TEST_F(Exodus, SidesHaveValuesOfTheirOwnOrOfTheElementsBehind)
{
    for (const bool polyhedra : {false, true}) {
        write({.polyhedra = polyhedra});
        const Scene lid = loadScene(describe(file_ + ":lid", "", "pressure", true));
        ASSERT_EQ(lid.surface.cellScalars.size(), 2 * kQuads);
        for (std::size_t i = 0; i < 2 * kQuads; ++i) EXPECT_EQ(lid.surface.cellScalars[i], 48 + float(i / 2));
        const Scene floor = loadScene(describe(file_ + ":floor", "", "shear", true));
        for (std::size_t i = 0; i < 2 * kQuads; ++i) EXPECT_EQ(floor.surface.cellScalars[i], float(i / 2));
        EXPECT_TRUE(std::isnan(loadScene(describe(file_ + ":lid", "", "shear", true)).surface.cellScalars[0]));
    }
}

TEST_F(Exodus, ShellsAreTheSurfaceWhereThereAreSome)
{
    write({.shells = true});
    const Scene scene = loadScene(describe(file_));
    EXPECT_EQ(scene.surface.triangles.size(), 2 * kQuads);
    EXPECT_EQ(scene.surface.originWorld.z, 5);
    expectFlow(scene);
}

/// Both blocks have their nodes in common, so that a slice through both has no seam.
TEST_F(Exodus, AllBlocksAreTheField)
{
    for (const bool polyhedra : {false, true}) {
        write({.polyhedra = polyhedra, .shells = true});
        const Scene scene = loadScene(describe("slice:2,2,2:1,0,0", file_, "temp"));
        EXPECT_NEAR(areaOf(scene.surface), 16, 1e-5);
        expectFlow(scene);
        EXPECT_NEAR(areaOf(loadScene(describe("slice:2,2,2:1,0,0", file_ + ":high")).surface), 8, 1e-5);
        EXPECT_NEAR(areaOf(loadScene(describe("boundary", file_)).surface), 6 * 16, 1e-5);
        expectFlow(loadScene(describe(file_ + ":lid", file_)));
    }
}

/// Nodes at the same place are not made one: nothing flows through a wall between two blocks.
TEST_F(Exodus, NodesThatAreTwoStayTwo)
{
    write({.split = true});
    EXPECT_NEAR(areaOf(loadScene(describe("boundary", file_)).surface), 6 * 16 + 2 * 16, 1e-5);
}

TEST_F(Exodus, TimesAndNodesThatMove)
{
    for (const Form form : {Form::offsets64, Form::netcdf4})
        for (const bool moves : {false, true}) {
            write({.form = form, .moves = moves, .steps = 3});
            SceneDescription description = describe(file_ + ":floor");
            for (const double time : {0.0, 0.5, 1.0, 0.25, 7.0}) {
                description.time.moment = time;
                const double step = 2 * std::min(time, 1.0);
                const Scene scene = loadScene(description);
                EXPECT_NEAR(double(scene.surface.positions[0].z) + scene.surface.originWorld.z, moves ? step : 0, 1e-6);
                expectFlow(scene, step, moves ? step : 0);
            }
        }
}

TEST_F(Exodus, AMeshWithoutValuesTakesThoseOfAField)
{
    write({.values = false});
    SceneDescription description = describe(file_ + ":floor", "abc:8,8,8");
    description.field.vectors = "";
    EXPECT_EQ(loadScene(description).surface.triangles.size(), 2 * kQuads);
    EXPECT_THROW(loadScene(describe(file_)), InputError);
    EXPECT_NE(describeFile(file_).find("no arrays"), std::string::npos) << describeFile(file_);
}

TEST_F(Exodus, SidesOfEveryElementAreThoseOfTheLibrary)
{
    writeExodusElements(file_);
    const NetcdfFile file(file_);
    const auto blocks = readExodusBlocks(file);
    const ExodusSides sides = readExodusSides(file, readExodusSideSets(file).at(0), blocks, 55);
    const auto expected = exodusSides(file_);
    ASSERT_EQ(expected.size(), 6U + 4 + 5 + 5 + 2 + 2);
    ASSERT_EQ(sides.faces.count(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        std::vector<int> corners;
        for (const std::int64_t corner : sides.faces.face(i)) corners.push_back(int(corner) + 1);
        // The library names the nodes between the corners behind them.
        EXPECT_EQ(corners, std::vector<int>(expected[i].begin(), expected[i].begin() + std::ptrdiff_t(corners.size())))
            << i;
        EXPECT_EQ(corners.size() == 3, expected[i].size() == 3 || expected[i].size() == 6) << i;
    }
    EXPECT_NEAR(areaOf(loadScene([&] {
                           SceneDescription description = describe(file_ + ":block_1,block_3", "abc:8,8,8");
                           description.field.vectors = "";
                           return description;
                       }())
                           .surface),
                6 + 3 + std::sqrt(2.0), 1e-5);
}

TEST_F(Exodus, FilesOfVtksWriter)
{
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> flow;
    flow->SetName("vel");
    flow->SetNumberOfComponents(3);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p(i & 1, i >> 1 & 1, i >> 2);
        points->InsertNextPoint(p.x, p.y, p.z);
        const glm::dvec3 v = exodusFlow(p);
        flow->InsertNextTuple3(v.x, v.y, v.z);
    }
    const vtkIdType corners[] = {0, 1, 3, 2, 4, 5, 7, 6};
    grid->SetPoints(points);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
    grid->GetPointData()->AddArray(flow);
    vtkNew<vtkExodusIIWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileName(file_.c_str());
    writer->Write();
    const Scene scene = loadScene(describe("boundary", file_));
    EXPECT_NEAR(areaOf(scene.surface), 6, 1e-5);
    expectFlow(scene);
}

TEST_F(Exodus, InfoListsPartsTimesAndCommands)
{
    write({.steps = 3});
    const std::string told = describeFile(file_);
    for (const char* text :
         {"an Exodus file", "low    HEX8         32  block_10", "floor  side set     16  sideset_100",
          "time steps  3, from 0 to 1", "points      150", "cells       64", "vel       points  double",
          "shear     cells ", "box.e:floor --vectors vel", "--time 0.5"})
        EXPECT_NE(told.find(text), std::string::npos) << text << " is not in:\n" << told;
}

}  // namespace
}  // namespace aeolic
