#include "data/vtk/data_objects.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataSet.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/surface/surface_file.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

/// A square of two triangles.
vtkSmartPointer<vtkPolyData> square(double x)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = {0, 1, 2, 3};
    points->InsertNextPoint(x, 0, 0);
    points->InsertNextPoint(x + 1, 0, 0);
    points->InsertNextPoint(x + 1, 1, 0);
    points->InsertNextPoint(x, 1, 0);
    cells->InsertNextCell(4, corners);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

/// "car" with the squares "left" and "right", beside "box", which has cells.
void writeBlocks(const std::string& path)
{
    vtkNew<vtkMultiBlockDataSet> all, car;
    const auto name = [](vtkMultiBlockDataSet& blocks, unsigned number, const char* text) {
        blocks.GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), text);
    };
    for (const unsigned side : {0u, 1u}) {
        car->SetBlock(side, square(3.0 * side));
        name(*car, side, side == 0 ? "left" : "right");
    }
    vtkNew<vtkImageData> box;
    box->SetDimensions(3, 3, 3);
    all->SetBlock(0, car);
    name(*all, 0, "car");
    all->SetBlock(1, box);
    name(*all, 1, "box");
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(all);
    writer->Write();
}

std::size_t triangles(const std::string& path, const std::vector<std::string>& parts)
{
    SurfaceArrays arrays;
    arrays.parts = parts;
    return readSurfaceFile(path, arrays, {}).mesh.triangles.size();
}

TEST(Blocks, AreChosenByNameInTheirTree)
{
    const test::TempFolder folder;
    const std::string path = folder.file("a.vtm");
    writeBlocks(path);
    EXPECT_EQ(triangles(path, {"car/left"}), 2u);
    EXPECT_EQ(triangles(path, {"left"}), 2u);
    EXPECT_EQ(triangles(path, {"car"}), 4u);
    EXPECT_EQ(triangles(path, {}), 4u) << "the box has no polygons";
    EXPECT_EQ(triangles(path, {"box"}), 48u) << "its outer surface: 6 sides of 4 squares";
    EXPECT_EQ(triangles(path, {"*"}), 4u + 48);
    try {
        triangles(path, {"lef"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("car/left, car/right, box"), std::string::npos) << error.what();
    }
    EXPECT_NE(describeFile(path).find("car/right"), std::string::npos);
}

/// A block whose array has other components than the first block's counts as one without it.
TEST(Blocks, ThatDifferInAnArraysComponentsAreBlankThere)
{
    const test::TempFolder folder;
    test::SheetSample sheet;
    test::writeSheetFile(folder.file("vectors.vtp"), sheet);
    sheet.tauComponents = 1;
    sheet.shift = {2, 0, 0};
    test::writeSheetFile(folder.file("scalars.vtp"), sheet);
    test::writeBytes(folder.file("a.vtm"),
                     "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>"
                     "<DataSet index=\"0\" name=\"v\" file=\"vectors.vtp\"/>"
                     "<DataSet index=\"1\" name=\"s\" file=\"scalars.vtp\"/></vtkMultiBlockDataSet></VTKFile>");
    SceneDescription description;
    description.surface.spec = folder.file("a.vtm");
    description.field.vectors = "tau";
    const Scene scene = loadScene(description);
    const auto& vectors = scene.surface.pointVectors;
    ASSERT_EQ(vectors.size(), 50u);
    EXPECT_EQ(std::count_if(vectors.begin(), vectors.end(), [](const glm::vec3& v) { return std::isnan(v.x); }), 25);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_NE(scene.warnings.front().find("25 not finite of 50"), std::string::npos) << scene.warnings.front();
}

/// Files that name files: "outer.vtm" has "a.vtm" as "inner", and "b.vtp" twice, once in pieces.
TEST(Blocks, FilesWithinFilesAreOneTree)
{
    const test::TempFolder folder;
    writeBlocks(folder.file("a.vtm"));
    test::writeSheetFile(folder.file("b.vtp"));
    const std::string path = folder.file("outer.vtmb");
    test::writeBytes(path, R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<Block index="1" name="second"><DataSet index="0" name="inner" file="a.vtm"/><DataSet index="1"/></Block>
<Piece index="0" name="first"><DataSet index="0" file="b.vtp"/><DataSet index="1" file="b.vtp"/></Piece>
<DataSet index="2" file="b.vtp"/></vtkMultiBlockDataSet></VTKFile>)");
    EXPECT_EQ(triangles(path, {"second/inner/car/left"}), 2u);
    EXPECT_EQ(triangles(path, {"second/inner"}), 4u + 48);
    EXPECT_EQ(triangles(path, {"second"}), 4u + 48);
    EXPECT_EQ(triangles(path, {"first"}), 64u);
    EXPECT_EQ(triangles(path, {"2"}), 32u);
    EXPECT_EQ(triangles(path, {}), 4u + 64 + 32);
}

/// Where triangles lie at the same depth the picture shows the first one, so it depends on the order of the blocks.
/// That is the order of their numbers, not of the lines in the file or of the names that the user gives.
TEST(Blocks, ComeInTheOrderOfTheirNumbers)
{
    const test::TempFolder folder;
    for (const int i : {0, 1, 2}) {
        test::SheetSample sheet;
        sheet.shift = {2.0 * i, 0, 0};
        test::writeSheetFile(folder.file(std::to_string(i) + ".vtp"), sheet);
    }
    const std::string path = folder.file("a.vtm");
    test::writeBytes(path, R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="2" name="c" file="2.vtp"/><DataSet index="0" name="a" file="0.vtp"/>
<DataSet index="1" name="b" file="1.vtp"/></vtkMultiBlockDataSet></VTKFile>)");
    for (const std::vector<std::string>& wanted : {std::vector<std::string>{}, {"c", "a", "b"}, {"b", "*"}}) {
        SurfaceArrays arrays;
        arrays.parts = wanted;
        const SurfaceMesh mesh = readSurfaceFile(path, arrays, {}).mesh;
        ASSERT_EQ(mesh.triangles.size(), 3u * 32);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const double x = mesh.originWorld.x + double(mesh.positions[mesh.triangles[i][0]].x);
            EXPECT_EQ(std::floor(x / 2), double(i / 32)) << "triangle " << i << " at " << x;
        }
    }
}

/// What nobody asks for may be damaged: it is not opened.
TEST(Blocks, OnlyBlocksThatAreWantedAreRead)
{
    const test::TempFolder folder;
    const std::string path = folder.file("a.vtm");
    writeBlocks(path);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
        if (entry.path().extension() == ".vti") test::writeBytes(entry.path().string(), "no XML");
    EXPECT_EQ(triangles(path, {}), 4u);
    EXPECT_EQ(triangles(path, {"car"}), 4u);
    EXPECT_THROW(triangles(path, {"box"}), InputError);
    EXPECT_THROW(describeFile(path), InputError);
}

TEST(Blocks, AnArrayThatABlockLacksIsMissingThere)
{
    const test::TempFolder folder;
    test::SheetSample bare;
    bare.arrays = false;
    test::writeSheetFile(folder.file("a.vtp"));
    test::writeSheetFile(folder.file("b.vtp"), bare);
    const std::string path = folder.file("a.vtm");
    test::writeBytes(path, R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="0" name="a" file="a.vtp"/><DataSet index="1" name="b" file="b.vtp"/></vtkMultiBlockDataSet></VTKFile>)");
    const LoadedSurface surface = readSurfaceFile(path, {true, "tau", ""}, {});
    ASSERT_EQ(surface.mesh.pointVectors.size(), 50u);
    EXPECT_EQ(surface.mesh.pointVectors.front().x, 1);
    EXPECT_TRUE(std::isnan(surface.mesh.pointVectors.back().x));
}

/// A sheet of two triangles with U of the type, or without it.
void writeTyped(const std::string& path, const std::string& type)
{
    const auto array = [](const std::string& attributes, const std::string& values) {
        return "<DataArray format=\"ascii\" " + attributes + ">" + values + "</DataArray>";
    };
    const std::string vectors = "Name=\"U\" NumberOfComponents=\"3\"";
    test::writeBytes(
        path,
        "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"4\" "
        "NumberOfPolys=\"2\"><PointData>" +
            (type.empty() ? "" : array("type=\"" + type + "\" " + vectors, "1 0 0 1 0 0 1 0 0 1 0 0")) +
            "</PointData><Points>" + array("type=\"Float32\" NumberOfComponents=\"3\"", "0 0 0 1 0 0 1 1 0 0 1 0") +
            "</Points><Polys>" + array("type=\"Int64\" Name=\"connectivity\"", "0 1 2 0 2 3") +
            array("type=\"Int64\" Name=\"offsets\"", "3 6") + "</Polys></Piece></PolyData></VTKFile>");
}

TEST(Blocks, ArraysOfOtherTypesAreTheSame)
{
    const test::TempFolder folder;
    writeTyped(folder.file("a.vtp"), "Float64");
    writeTyped(folder.file("b.vtp"), "Float32");
    writeTyped(folder.file("c.vtp"), "Int32");
    writeTyped(folder.file("d.vtp"), "");
    const std::string path = folder.file("a.vtm");
    test::writeBytes(path, R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="0" file="a.vtp"/><DataSet index="1" file="b.vtp"/><DataSet index="2" file="c.vtp"/>
<DataSet index="3" file="d.vtp"/></vtkMultiBlockDataSet></VTKFile>)");
    const auto vectors = readSurfaceFile(path, {true, "U", ""}, {}).mesh.pointVectors;
    ASSERT_EQ(vectors.size(), 16u);
    EXPECT_EQ(std::count(vectors.begin(), vectors.end(), glm::vec3(1, 0, 0)), 12);
    EXPECT_TRUE(std::isnan(vectors.back().x)) << "the last block has none";
}

TEST(Blocks, OthersThanPolygonsAreToldOf)
{
    const test::TempFolder folder;
    const std::string path = folder.file("a.vtm");
    writeBlocks(path);
    const auto warnings = readSurfaceFile(path, {}, {}).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("1 of 3 blocks left out: they are not polygons but image data"), std::string::npos)
        << warnings[0];
}

TEST(Blocks, ThoseThatFillSpaceAreAField)
{
    const test::TempFolder folder;
    test::GridSample right;
    right.origin[0] += 2;
    test::writeGridFile(folder.file("l.vtu"));
    test::writeGridFile(folder.file("r.vtu"), right);
    test::writeSheetFile(folder.file("s.vtp"));
    const std::string path = folder.file("a.vtm");
    test::writeBytes(path, R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>
<DataSet index="0" name="left" file="l.vtu"/><DataSet index="1" name="right" file="r.vtu"/>
<DataSet index="2" name="sheet" file="s.vtp"/></vtkMultiBlockDataSet></VTKFile>)");
    const auto widthOf = [&](const std::string& field) {
        SceneDescription description;
        description.surface.spec = "slice:0,0.5,1:0,0,1";
        description.field.spec = field;
        description.field.vectors = "U";
        const Bounds bounds = loadScene(description).surface.bounds();
        return bounds.hi.x - bounds.lo.x;
    };
    EXPECT_NEAR(widthOf(path), 4, 1e-5);
    EXPECT_NEAR(widthOf(path + ":right"), 2, 1e-5);
}

TEST(Blocks, AFileOfOnePieceHasNoParts)
{
    const test::TempFolder folder;
    test::writeSheetFile(folder.file("a.vtp"));
    EXPECT_THROW(triangles(folder.file("a.vtp"), {"left"}), InputError);
}

}  // namespace
}  // namespace aeolic
