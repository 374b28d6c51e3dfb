#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/loaded_surface.h"
#include "data/vtk/surface/polydata_mesh.h"
#include "data/vtk/surface/surface_file.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

using namespace test;

constexpr double featureAngleDeg = 20;

LoadedSurface read(const std::string& path, const SurfaceArrays& arrays = {})
{
    LoadedSurface surface = readSurfaceFile(path, arrays, {});
    finishSurface(surface, featureAngleDeg);
    return surface;
}

/// Gives each cell its number as the array "q".
void numberCells(vtkPolyData& data)
{
    vtkNew<vtkFloatArray> numbers;
    numbers->SetName("q");
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) numbers->InsertNextValue(float(cell));
    data.GetCellData()->AddArray(numbers);
}

std::vector<std::string> allWarningsOf(const LoadedSurface& surface)
{
    std::vector<std::string> all = surface.warnings;
    for (const Tally& tally : surface.tallies)
        for (const std::string& warning : warningsOf(tally)) all.push_back(warning);
    return all;
}

struct Format {
    const char* file;
    Encoding encoding;
    SheetSample::Cells cells;
    std::size_t triangles;
};

class EverySurfaceFormat : public testing::TestWithParam<Format> {};

TEST_P(EverySurfaceFormat, GivesTheSameTriangles)
{
    const TempFolder folder;
    SheetSample sample;
    sample.encoding = GetParam().encoding;
    sample.cells = GetParam().cells;
    writeSheetFile(folder.file(GetParam().file), sample);
    const LoadedSurface surface = read(folder.file(GetParam().file));
    EXPECT_EQ(surface.mesh.triangles.size(), GetParam().triangles);
    EXPECT_EQ(allWarningsOf(surface), std::vector<std::string>());
    double area = 0;
    for (const auto& t : surface.mesh.triangles) {
        const glm::vec3 a = surface.mesh.positions[t[0]], b = surface.mesh.positions[t[1]],
                        c = surface.mesh.positions[t[2]];
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    const double sheet = std::sqrt(1.01);  // 1 x 1 seen from above, rising by 0.1.
    EXPECT_NEAR(area, GetParam().triangles == 64 ? 2 * sheet : sheet, 1e-5);
    for (const glm::vec3& n : surface.mesh.normals) EXPECT_NEAR(std::abs(n.z), 1 / sheet, 1e-5);
}

using Cells = SheetSample::Cells;
INSTANTIATE_TEST_SUITE_P(
    Files, EverySurfaceFormat,
    testing::Values(
        Format{"s.vtp", Encoding::raw, Cells::quads, 32}, Format{"s.vtp", Encoding::zlib, Cells::strips, 32},
        Format{"s.vtp", Encoding::ascii, Cells::triangles, 32}, Format{"s.pvtp", Encoding::raw, Cells::quads, 32},
        Format{"s.vtk", Encoding::raw, Cells::quads, 32}, Format{"s.vtk", Encoding::ascii, Cells::strips, 32},
        Format{"s.stl", Encoding::raw, Cells::triangles, 32}, Format{"s.stl", Encoding::ascii, Cells::triangles, 32},
        Format{"s.ply", Encoding::raw, Cells::quads, 32}, Format{"s.ply", Encoding::ascii, Cells::triangles, 32},
        Format{"s.obj", Encoding::ascii, Cells::quads, 32}, Format{"s.vtm", Encoding::raw, Cells::quads, 64}));

TEST(LoadSurface, ArraysFollowTheirPointsAndCells)
{
    const TempFolder folder;
    writeSheetFile(folder.file("s.vtp"));
    const LoadedSurface onPoints = read(folder.file("s.vtp"), {true, "tau", "q"});
    ASSERT_EQ(onPoints.mesh.pointVectors.size(), onPoints.mesh.positions.size());
    for (std::size_t i = 0; i < onPoints.mesh.positions.size(); ++i) {
        const glm::dvec3 p = onPoints.mesh.originWorld + glm::dvec3(onPoints.mesh.positions[i]);
        EXPECT_NEAR(onPoints.mesh.pointVectors[i].y, p.x, 1e-6);
        EXPECT_NEAR(onPoints.mesh.pointScalars[i], p.x + p.y, 1e-6);
    }
    const LoadedSurface onCells = read(folder.file("s.vtp"), {true, "cellTau", "cellQ"});
    ASSERT_EQ(onCells.mesh.cellVectors.size(), 32u);
    ASSERT_EQ(onCells.mesh.cellScalars.size(), 32u);
    for (std::size_t i = 0; i < 32; ++i) {
        const auto& t = onCells.mesh.triangles[i];
        const glm::dvec3 p =
            onCells.mesh.originWorld +
            glm::dvec3(onCells.mesh.positions[t[0]] + onCells.mesh.positions[t[1]] + onCells.mesh.positions[t[2]]) /
                3.0;
        EXPECT_EQ(onCells.mesh.cellScalars[i], std::floor(4 * p.y) * 4 + std::floor(4 * p.x));
    }
}

TEST(LoadSurface, ArraysOfBlocksAreAppended)
{
    const TempFolder folder;
    writeSheetFile(folder.file("s.vtm"));
    const LoadedSurface surface = read(folder.file("s.vtm"), {true, "tau", ""});
    EXPECT_EQ(surface.mesh.pointVectors.size(), surface.mesh.positions.size());
    EXPECT_NEAR(surface.mesh.bounds().hi.x, 2, 1e-6);
}

TEST(LoadSurface, NormalsOfTheFileAreKept)
{
    const TempFolder folder;
    SheetSample sample;
    sample.normals = true;
    writeSheetFile(folder.file("s.vtp"), sample);
    for (const glm::vec3& n : read(folder.file("s.vtp")).mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, -1));
}

TEST(LoadSurface, TrianglesAtNonFinitePointsAreDroppedAndCounted)
{
    const TempFolder folder;
    SheetSample sample;
    sample.cells = SheetSample::Cells::triangles;
    sample.encoding = Encoding::raw;
    writeSheetFile(folder.file("s.vtk"), sample);
    std::string bytes = readBytes(folder.file("s.vtk"));
    // Legacy binary floats are big-endian and follow the header line; the text form has no NaN.
    const std::size_t firstPoint = bytes.find("float\n", bytes.find("POINTS")) + 6;
    bytes.replace(firstPoint, 4, std::string("\x7f\xc0\x00\x00", 4));
    writeBytes(folder.file("s.vtk"), bytes);
    const LoadedSurface surface = read(folder.file("s.vtk"));
    EXPECT_LT(surface.mesh.triangles.size(), 32u);
    const std::vector<std::string> warnings = allWarningsOf(surface);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("of 32 cells left out: a corner is not finite"), std::string::npos);
    EXPECT_EQ(surface.mesh.bounds().lo.y, 0);
}

TEST(LoadSurface, HolesOfABoundaryAreToldOf)
{
    const TempFolder folder;
    GridSample sample;
    sample.legacyKind = 3;
    const std::string path = folder.file("g.vtk");
    writeGridFile(path, sample);
    std::string bytes = readBytes(path);
    const std::size_t firstPoint = bytes.find('\n', bytes.find("POINTS")) + 1;
    writeBytes(path, bytes.replace(firstPoint, 4, std::string("\x7f\xf8\x00\x00", 4)));
    SceneDescription description;
    description.surface.spec = "boundary";
    description.field.spec = path;
    const Scene scene = loadScene(description);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_NE(scene.warnings[0].find("6 of 584 cells left out: a corner is not finite"), std::string::npos)
        << scene.warnings[0];
}

/// VTK's own table of cells does not take polygons of fewer than three points.
TEST(LoadSurface, PolygonsOfTwoPointsBesideOneThatIsNotFinite)
{
    vtkNew<vtkPoints> points;
    for (const double x : {0.0, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()})
        points->InsertNextPoint(x, x * x, 0);
    vtkNew<vtkCellArray> vertices, polygons;
    vertices->InsertNextCell({3});
    for (const std::initializer_list<vtkIdType>& polygon :
         {std::initializer_list<vtkIdType>{0, 1}, {1, 2, 3}, {}, {2}, {0, 1, 2}})
        polygons->InsertNextCell(polygon);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    data->SetPolys(polygons);
    numberCells(*data);
    LoadedSurface surface = meshFromPolyData(*data, "two", {false, "", "q"}, false, "");
    finishSurface(surface, featureAngleDeg);
    ASSERT_EQ(surface.mesh.triangles.size(), 1u);
    EXPECT_EQ(surface.mesh.bounds().hi.x, 2);
    const std::vector<std::string> warnings = allWarningsOf(surface);
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings[0].find("2 of 6 cells left out: a corner is not finite"), std::string::npos) << warnings[0];
    EXPECT_EQ(surface.mesh.cellScalars, std::vector<float>{5}) << "of the cell that is left";
}

/// A quadrilateral that crosses itself between two that do not, and a strip: values stay with their cells.
TEST(LoadSurface, PolygonsThatVtkDoesNotCutAreFans)
{
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 2; ++j) points->InsertNextPoint(i, j, 0);
    vtkNew<vtkCellArray> polygons, strips;
    for (const std::initializer_list<vtkIdType>& polygon :
         {std::initializer_list<vtkIdType>{0, 2, 3, 1}, {2, 4, 3, 5}, {4, 6, 7, 5}})
        polygons->InsertNextCell(polygon);
    strips->InsertNextCell({0, 1, 2, 3});
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(polygons);
    data->SetStrips(strips);
    numberCells(*data);
    const LoadedSurface surface = meshFromPolyData(*data, "crossed", {false, "", "q"}, false, "");
    EXPECT_EQ(surface.mesh.cellScalars, (std::vector<float>{0, 0, 1, 1, 2, 2, 3, 3}));
    ASSERT_EQ(surface.mesh.triangles.size(), 8u);
}

/// A polygon that is cut into several triangles counts once, and a line, which is not drawn, not at all. The caller's
/// values stay as they are.
TEST(LoadSurface, MaskedCellsAreCountedAsTheFileHasThem)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const auto check = [](vtkDataArray& values, const std::vector<double>& ofCells, std::int64_t notFinite) {
        vtkNew<vtkPoints> points;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 2; ++j) points->InsertNextPoint(i, j, 0);
        vtkNew<vtkCellArray> lines, polygons;
        lines->InsertNextCell({0, 1});
        polygons->InsertNextCell({0, 2, 3, 1});
        polygons->InsertNextCell({2, 4, 5, 3});
        vtkNew<vtkPolyData> data;
        data->SetPoints(points);
        data->SetLines(lines);
        data->SetPolys(polygons);
        values.SetName("q");
        values.SetNumberOfTuples(3);
        for (int i = 0; i < 3; ++i) values.SetComponent(i, 0, ofCells[std::size_t(i)]);
        data->GetCellData()->AddArray(&values);
        const LoadedSurface surface = meshFromPolyData(*data, "s", {false, "", "q"}, false, "");
        const auto tally = std::find_if(surface.tallies.begin(), surface.tallies.end(),
                                        [](const Tally& t) { return t.of == Tally::Of::maskedCells; });
        ASSERT_NE(tally, surface.tallies.end());
        EXPECT_EQ(tally->found, 0);
        EXPECT_EQ(tally->also, notFinite);
        EXPECT_EQ(tally->all, 3);
        EXPECT_EQ(std::isinf(values.GetComponent(1, 0)), std::isinf(ofCells[1]));
    };
    for (const bool doubles : {false, true}) {
        const auto values = [&] {
            return vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(doubles ? VTK_DOUBLE : VTK_FLOAT));
        };
        check(*values(), {1, 2, 3}, 0);
        check(*values(), {1, inf, 3}, 1);
        check(*values(), {nan, inf, nan}, 3);
        check(*values(), {nan, 2, 3}, 0);
    }
}

/// The squares of 1e25 are no floats, yet its streaks show.
TEST(LoadSurface, VectorsBeyondThePictureAreToldOf)
{
    for (const double scale : {1e-33, 1e-25, 1.0, 1e25, 1.5e38}) {
        const TempFolder folder;
        SheetSample sample;
        sample.scale = scale;
        writeSheetFile(folder.file("s.vtp"), sample);
        SceneDescription description;
        description.surface.spec = folder.file("s.vtp");
        description.field.vectors = "tau";
        const Scene scene = loadScene(description);
        EXPECT_NEAR(scene.maxVector / scale, std::sqrt(2.01), 1e-5);
        std::string all;
        for (const std::string& warning : scene.warnings) all += warning;
        EXPECT_EQ(all.find("streaks need vectors of 1e-32 to 1e+38") != std::string::npos,
                  scale < 1e-32 || scale > 1e38)
            << all;
        EXPECT_EQ(all.find("all vectors are zero"), std::string::npos) << all;
    }
}

TEST(LoadSurface, DegenerateTrianglesAreDroppedAndCounted)
{
    const TempFolder folder;
    SheetSample sample;
    sample.degenerate = 3;
    writeSheetFile(folder.file("s.vtp"), sample);
    const LoadedSurface surface = read(folder.file("s.vtp"));
    EXPECT_EQ(surface.mesh.triangles.size(), 32u);
    const std::vector<std::string> warnings = allWarningsOf(surface);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("3 of 35 triangles left out: they have no area"), std::string::npos) << warnings[0];
}

TEST(LoadSurface, PlyKeepsNormalsAndOtherNumbersOfEitherByteOrder)
{
    const TempFolder folder;
    const std::string header =
        " 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty float z\nproperty float nx\n"
        "property float ny\nproperty float nz\nproperty uchar heat\nelement face 1\n"
        "property list uchar short vertex_index\nend_header\n";
    writeBytes(folder.file("text.ply"),
               "ply\nformat ascii" + header + "0 0 0 0 0 2 7\n1 0 0 0 0 2 8\n0 1 0 0 0 2 9\n3 0 1 2");
    const auto number = [](auto value, bool big) {
        std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
        return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    };
    for (const bool big : {false, true}) {
        std::string data = big ? "ply\nformat binary_big_endian" + header : "ply\nformat binary_little_endian" + header;
        for (int i = 0; i < 3; ++i) {
            data += number(float(i == 1), big) + number(double(i == 2), big) + number(0.0f, big);
            data += number(0.0f, big) + number(0.0f, big) + number(2.0f, big) + char(7 + i);
        }
        data += '\3' + number(short(0), big) + number(short(1), big) + number(short(2), big);
        writeBytes(folder.file(big ? "big.ply" : "little.ply"), data);
    }
    for (const char* name : {"text.ply", "little.ply", "big.ply"}) {
        const LoadedSurface surface = read(folder.file(name), {false, "", "heat"});
        ASSERT_EQ(surface.mesh.triangles.size(), 1u) << name;
        EXPECT_EQ(surface.mesh.pointScalars, (std::vector<float>{7, 8, 9})) << name;
        EXPECT_EQ(surface.mesh.normals[0], glm::vec3(0, 0, 1)) << name;
        EXPECT_EQ(surface.mesh.bounds().hi, glm::dvec3(1, 1, 0)) << name;
    }
}

/// Normals of some faces alone do not count: all follow from the faces, as in the file without them.
TEST(LoadSurface, ObjFacesWithAndWithoutNormalsAndTextures)
{
    const TempFolder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\n";
    writeBytes(folder.file("plain.obj"), points + "f 1 2 3\nf 1 3 4\nf 1 2 5\n");
    const LoadedSurface plain = read(folder.file("plain.obj"));
    ASSERT_EQ(plain.mesh.triangles.size(), 3u);
    int number = 0;
    for (const std::string faces :
         {"f 1 2 3\nf 1//1 3//1 4//1\nf 1//2 2//2 5//2\n", "f 1//1 2//1 3//1\r\nf 1 3 4\r\nf 1 2 5\r\n",
          "g a\nf 1//1 \\\n 2//1 3//1\ng b\nf 1 3 4\nf -5//-1 -4//-1 -1//-1\nl 1 2\n"}) {
        writeBytes(folder.file("mixed.obj"), points + faces);
        const LoadedSurface surface = read(folder.file("mixed.obj"));
        EXPECT_EQ(surface.mesh.triangles, plain.mesh.triangles) << ++number;
        EXPECT_EQ(surface.mesh.positions, plain.mesh.positions) << number;
        EXPECT_EQ(surface.mesh.normals, plain.mesh.normals) << number;
    }
    writeBytes(folder.file("mixed.obj"), points + "f 1/1/1 2/2/1 3/1/1\nf 1/1 3/1 4/2\nf 1 2 5\n");
    EXPECT_EQ(read(folder.file("mixed.obj")).mesh.triangles.size(), 3u);
}

TEST(LoadSurface, FarFromTheOriginPositionsKeepTheirPrecision)
{
    const TempFolder folder;
    SheetSample sample;
    sample.shift = {5e5, 4e6, 0};  // Map coordinates; a float's step there is 0.5.
    writeSheetFile(folder.file("s.obj"), sample);
    const LoadedSurface surface = read(folder.file("s.obj"));
    EXPECT_LT(glm::length(glm::dvec3(surface.mesh.positions[0])), 1.0);
}

TEST(LoadSurface, VectorsOfTheSurfaceNeedNoField)
{
    const TempFolder folder;
    writeSheetFile(folder.file("s.vtp"));
    SceneDescription description;
    description.surface.spec = folder.file("s.vtp");
    description.field.vectors = "tau";
    description.shading.colorBy = "tau:mag";
    const Scene scene = loadScene(description);
    EXPECT_FALSE(scene.field);
    EXPECT_NEAR(scene.maxVector, std::sqrt(2.01), 1e-6);
    EXPECT_NEAR(scene.scalarRange[1], std::sqrt(2.01), 1e-6);
    EXPECT_EQ(scene.scalarName, "|tau|");
}

}  // namespace
}  // namespace aeolic
