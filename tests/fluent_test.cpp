#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFLUENTReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
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
#include "reader/fluent/testing/sample_fluent.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;
using Form = SampleFluent::Form;

constexpr std::size_t kQuads = 16;
constexpr Form allForms[] = {Form::text, Form::floats, Form::doubles};

class Fluent : public testing::Test {
protected:
    void write(const SampleFluent& sample = {}) const { writeSampleFluent(file_, sample); }

    static SceneDescription describe(const std::string& surface, const std::string& field = "",
                                     const std::string& colorBy = "", const std::string& vectors = "VELOCITY")
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.surface.cells = CellValues::steps;
        description.field.spec = field;
        description.field.vectors = vectors;
        description.shading.colorBy = colorBy;
        return description;
    }

    std::string complaint(const std::string& part = ":floor") const
    {
        return complaintOf([&] {
            loadScene(describe(file_ + part, "", "PRESSURE"));
            loadScene(describe("boundary", file_));
        });
    }

    void expectComplaint(const std::vector<std::string>& texts, const std::string& part = ":floor") const
    {
        expectSays(complaint(part), texts);
    }

    void expectChange(const std::string& was, const std::string& with, const std::vector<std::string>& texts,
                      const char* ending = ".cas") const
    {
        write();
        const std::string path = folder_.file(std::string("box") + ending);
        std::string text = readBytes(path);
        const std::size_t at = text.find(was);
        ASSERT_NE(at, std::string::npos) << was;
        writeBytes(path, text.replace(at, was.size(), with));
        expectComplaint(texts);
    }

    TempFolder folder_;
    std::string file_ = folder_.file("box.cas");
};

TEST_F(Fluent, WallsAreTheSurfaceUnlessAPartIsNamed)
{
    for (const Form form : allForms)
        for (const bool bigEndian : {false, true}) {
            write({.form = form, .bigEndian = bigEndian});
            EXPECT_EQ(loadScene(describe(file_)).surface.triangles.size(), 2 * 2 * kQuads);
            for (const char* name : {":floor", ":zone_4", ":fl*"})
                EXPECT_EQ(loadScene(describe(file_ + name)).surface.triangles.size(), 2 * kQuads) << name;
            EXPECT_EQ(loadScene(describe(file_ + ":velocity-inlet,rest")).surface.triangles.size(), 2 * 4 * kQuads);
            const SurfaceMesh box = loadScene(describe(file_ + ":air")).surface;
            EXPECT_NEAR(areaOf(box), 96, 1e-5);
        }
}

/// Two walls, each half of a tetrahedron.
std::string twoWalls(const std::string& first, const std::string& second)
{
    return "(0 \"C:\\\\cases\\\\\")\n(2 3)\n(10 (0 1 4 0 3))\n(10 (1 1 4 1 3)(\n0 0 1e-330\n1 0 0\n0 1 0\n0 0 1\n))\n"
           "(12 (0 1 1 0))\n(12 (2 1 1 1 2))\n(13 (0 1 4 0))\n(13 (3 1 2 3 3)(\n1 3 2 1 0\n1 2 4 1 0\n))\n"
           "(13 (4 3 4 3 3)(\n2 3 4 1 0\n1 4 3 1 0\n))\n(45 (2 fluid fl)())\n(45 (3 wall " +
           first + ")())\n(45 (4 wall " + second + ")())\n";
}

/// Backslashes before the quote that ends a text, numbers that no double holds, and a .dat of another program.
TEST_F(Fluent, NamesAreWhole)
{
    const std::string start = "wall-of-the-long-heat-exchanger-housing-upper-shell-";
    writeBytes(file_, twoWalls(start + "left", start + "right"));
    writeBytes(folder_.file("box.dat"), "VARIABLES = x, y\n");
    for (const char* name : {"left", "right"}) {
        SceneDescription description = describe(file_ + ":" + start + name, "abc:8,8,8");
        description.field.vectors = "";
        EXPECT_EQ(loadScene(description).surface.triangles.size(), 2U) << name;
    }
    writeBytes(file_, twoWalls("h\u00fclle", "h\u00f6hle"));
    EXPECT_NE(describeFile(file_).find("h\u00f6hle"), std::string::npos);
}

TEST_F(Fluent, EveryFormGivesTheSameBytes)
{
    for (const char* part : {":floor", ":lid,inlet", ":air"}) {
        std::vector<std::string> found;
        for (const Form form : allForms) {
            write({.form = form});
            found.push_back(fingerprint(loadScene(describe(file_ + part, "", "PRESSURE"))));
        }
        EXPECT_EQ(found, std::vector<std::string>(found.size(), found[0])) << part;
    }
}

TEST_F(Fluent, FacesLookOutwards)
{
    write();
    for (const char* part : {":floor,lid,inlet,rest", ":air"}) {
        const SurfaceMesh mesh = loadScene(describe(file_ + part)).surface;
        ASSERT_EQ(mesh.triangles.size(), 6 * 2 * kQuads);
        for (const auto& t : mesh.triangles) {
            const glm::vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a), 0) << part;  // Positions are relative to the middle.
        }
    }
}

TEST_F(Fluent, FacesHaveValuesOfTheirOwnOrOfTheCellsBehind)
{
    write();
    const SurfaceMesh lid = loadScene(describe(file_ + ":lid", "", "PRESSURE")).surface;
    for (std::size_t i = 0; i < 2 * kQuads; ++i) {
        EXPECT_EQ(lid.cellScalars[i], 48 + float(i / 2));
        const glm::dvec3 middle(double((i / 2) % 4) + 0.5, double(i / 8) + 0.5, 3.5), flow = fluentFlow(middle);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(lid.cellVectors[i][c]), flow[c], 1e-5);
    }
    const SurfaceMesh floor = loadScene(describe(file_ + ":floor", "", "", "WALL_SHEAR")).surface;
    for (std::size_t i = 0; i < 2 * kQuads; ++i) EXPECT_EQ(floor.cellVectors[i], glm::vec3(float(i / 2), 0, 1));
    EXPECT_TRUE(std::isnan(loadScene(describe(file_ + ":lid", "", "", "WALL_SHEAR")).surface.cellVectors[0].x));
}

TEST_F(Fluent, TheVolumeIsAField)
{
    write();
    const SurfaceMesh slice = loadScene(describe("slice:2,2,1.5:0,0,1", file_, "PRESSURE")).surface;
    EXPECT_NEAR(areaOf(slice), 16, 1e-5);
    const SurfaceMesh floor = loadScene(describe(file_ + ":floor", file_)).surface;
    EXPECT_FALSE(floor.pointVectors.empty());
}

/// The shapes are found from the faces; VTK's own reader finds the same.
TEST_F(Fluent, CellsOfEveryShape)
{
    write({.shapes = true});
    EXPECT_NEAR(
        areaOf(loadScene(describe(file_ + ":air")).surface),
        6 + (3 + std::sqrt(2.0)) + (1 + 1 + std::sqrt(2.0)) + (1.5 + std::sqrt(3.0) / 2) + (2.5 + 3 + std::sqrt(2.0)),
        1e-5);
    vtkNew<vtkFLUENTReader> reader;
    reader->SetFileName(file_.c_str());
    reader->Update();
    auto* theirs = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput()->GetBlock(0));
    ASSERT_TRUE(theirs);
    ASSERT_EQ(theirs->GetNumberOfCells(), 5);
    const std::string told = describeFile(file_);
    EXPECT_NE(told.find("air    volume      5"), std::string::npos) << told;
    for (const Form form : allForms) {
        write({.form = form});
        vtkNew<vtkFLUENTReader> box;
        box->SetFileName(file_.c_str());
        box->Update();
        auto* grid = vtkUnstructuredGrid::SafeDownCast(box->GetOutput()->GetBlock(0));
        ASSERT_EQ(grid->GetNumberOfCells(), 64);
        EXPECT_EQ(grid->GetCellType(7), VTK_HEXAHEDRON);
        EXPECT_EQ(grid->GetCellData()->GetArray("PRESSURE")->GetTuple1(7), 7);
        double bounds[6];
        grid->GetCellBounds(7, bounds);
        EXPECT_EQ((std::vector<double>(bounds, bounds + 6)), (std::vector<double>{3, 4, 1, 2, 0, 1}));
    }
}

TEST_F(Fluent, AFlatMeshIsASurface)
{
    for (const Form form : allForms) {
        write({.form = form, .flat = true});
        const SurfaceMesh mesh = loadScene(describe(file_, "", "PRESSURE")).surface;
        EXPECT_NEAR(areaOf(mesh), 16, 1e-5);
        ASSERT_EQ(mesh.triangles.size(), 2 * kQuads);
        EXPECT_EQ(mesh.cellScalars[8], 4);
        EXPECT_EQ(mesh.cellVectors[8].z, 0);
    }
}

TEST_F(Fluent, AMeshAloneHasNoValues)
{
    const std::string path = folder_.file("box.msh");
    writeSampleFluent(path, {.names = false});
    SceneDescription description = describe(path, "abc:8,8,8", "", "");
    EXPECT_EQ(loadScene(description).surface.triangles.size(), 2 * 2 * kQuads);
    description.surface.spec = path + ":zone_6";
    EXPECT_EQ(loadScene(description).surface.triangles.size(), 2 * kQuads);
    EXPECT_NE(describeFile(path).find("no arrays"), std::string::npos) << describeFile(path);
}

TEST_F(Fluent, InfoListsZonesAndCommands)
{
    write();
    const std::string told = describeFile(file_);
    for (const char* text :
         {"a Fluent case", "air    volume              64  zone_2", "inlet  velocity-inlet      16  zone_6",
          "floor  wall", "VELOCITY    cells", "WALL_SHEAR", "box.cas:floor --vectors"})
        EXPECT_NE(told.find(text), std::string::npos) << text << " is not in:\n" << told;
}

TEST_F(Fluent, Damaged)
{
    writeBytes(file_, "$MeshFormat\n");
    expectComplaint({"box.cas", "it is a mesh of Gmsh, not of Fluent"});
    writeBytes(file_, "$Mesh\n");
    expectComplaint({"box.cas", "does not begin like a Fluent file"});
    writeBytes(file_, "\x1f\x8b packed");
    expectComplaint({"box.cas", "packed by gzip"});
    writeBytes(file_, "(0 \"no mesh\")");
    expectComplaint({"box.cas", "no nodes or no faces"});
    expectChange("(2 3)", "(2 7)", {"box.cas", "7 dimensions"});
    expectChange("(2 3)", "(x 3)", {"box.cas", "no index"});
    expectChange("(2 3)", "?", {"box.cas", "found '?"});
    expectChange("(10 (1 1 7d 1 3)", "(10 (1 1 7e 1 3)", {"box.cas", "ends too early"});
    expectChange("(10 (1 1 7d 1 3)", "(10 (1 1 7fffffff 1 3)", {"box.cas", "ends too early"});
    expectChange("(10 (1 1 7d 1 3)", "(10 (1 2 7d 1 3)", {"box.cas", "begin at 2"});
    expectChange("(10 (1 1 7d 1 3)", "(10 (1 x 7d 1 3)", {"box.cas", "'x'"});
    expectChange("(12 (2 1 40 1 4))", "(12 (2 1 ffffff 1 4))", {"box.cas", "the cell 65 has 0 faces"});
    expectChange("(12 (2 1 40 1 4))", "(12 (2 1 3f 1 4))", {"box.cas", "between the cells", "0 to 63"});
    expectChange("(12 (2 1 40 1 4))", "(12 (2 1 40 1 4))(58 (1 1 1 1)(1 2))", {"box.cas", "hanging nodes"});
    expectChange("(45 (4 wall floor)())", "(45 (4 wall floor)()", {"box.cas", "cut off"});
    expectChange("3 4)(\n", "3 9)(\n", {"box.cas", "of the kind 9"});
    write();
    std::string text = readBytes(file_);
    const std::size_t faces = text.find("(13 (4 "), first = text.find("(\n", faces) + 2;
    writeBytes(file_, text.substr(0, first) + "7e" + text.substr(text.find(' ', first)));
    expectComplaint({"box.cas", "the corner 126", "1 to 125"});
    writeBytes(file_, text.substr(0, first) + "xyz" + text.substr(text.find(' ', first)));
    expectComplaint({"box.cas", "'xyz'", "base 16"});
    expectChange("(300 (1 2 1 0 0 1 64)", "(300 (1 2 1 0 0 1 65)", {"box.dat", "ends too early"}, ".dat");
    expectChange("(300 (1 2 1 0 0 1 64)", "(300 (1 2 1 0 0 1 99999999)", {"box.dat", "ends too early"}, ".dat");
    expectChange("(300 (1 2 1 0 0 1 64)", "(300 (1 2 1 0 0)", {"box.dat", "5 words"}, ".dat");
    expectChange("(300 (1 2 1 0 0 1 64)", "(300 (1 2 1 0 0 -1 64)", {"box.dat", "'-1'"}, ".dat");
    write({.form = Form::floats});
    std::string bytes = readBytes(file_);
    const std::size_t head = bytes.find("(2013 (4 "), body = bytes.find(")(", head) + 2;
    writeBytes(file_, bytes.erase(body, bytes.find("\nEnd", body) + 1 - body));
    expectComplaint({"box.cas", "a section (13 (4 ", "ends too early"});
}

TEST_F(Fluent, EveryLengthOfAFileThatIsCutOffIsRefused)
{
    for (const Form form : allForms) {
        write({.form = form});
        const std::string sound = readBytes(file_);
        for (std::size_t size = 0; size + 200 < sound.size(); size += 1 + sound.size() / 60) {
            writeBytes(file_, sound.substr(0, size));
            EXPECT_THROW(describeFile(file_), InputError) << size;
        }
    }
}

}  // namespace
}  // namespace aeolic
