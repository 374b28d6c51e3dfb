#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr int kQuad = 9, kHexahedron = 12, kLine = 3;

/// A grid of cells of several dimensions: a box of 3 x 3 x 3 hexahedra, and more.
class MixedGrid {
public:
    explicit MixedGrid(int layers = 3)
    {
        for (int z = 0; z <= layers; ++z)
            for (int y = 0; y <= 3; ++y)
                for (int x = 0; x <= 3; ++x) points_.push_back({double(x), double(y), double(z)});
        for (int z = 0; z < layers; ++z)
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 3; ++x) {
                    const int a = at(x, y, z), up = at(0, 0, 1);
                    add(kHexahedron, {a, a + 1, a + 5, a + 4, a + up, a + 1 + up, a + 5 + up, a + 4 + up}, 10);
                }
    }

    static int at(int x, int y, int z) { return x + 4 * y + 16 * z; }

    int addPoint(const glm::dvec3& point)
    {
        points_.push_back(point);
        return int(points_.size()) - 1;
    }
    void add(int type, const std::vector<int>& corners, double value)
    {
        cells_.push_back(corners);
        types_.push_back(type);
        values_.push_back(value);
    }
    /// The floor z = 0 once more, as quadrilaterals.
    void addFloor(double value)
    {
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x)
                add(kQuad, {at(x, y, 0), at(x + 1, y, 0), at(x + 1, y + 1, 0), at(x, y + 1, 0)}, value);
    }
    /// Shells that stand on the middle of the roof, five high.
    void addFin()
    {
        int a = at(1, 1, 3), b = at(2, 1, 3);
        for (int k = 1; k <= 5; ++k) {
            const int c = addPoint({2, 1, 3.0 + k}), d = addPoint({1, 1, 3.0 + k});
            add(kQuad, {a, b, c, d}, 100 + k);
            a = d;
            b = c;
        }
    }

    /// p and U = (p, 1, 0) on cells, or p = 10 + z and U = (1, 0, z) on points.
    void write(const std::string& path, bool onCells) const
    {
        std::string text = "# vtk DataFile Version 3.0\nmixed\nASCII\nDATASET UNSTRUCTURED_GRID\n";
        text += fmt::format("POINTS {} double\n", points_.size());
        for (const glm::dvec3& p : points_) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
        std::size_t numbers = 0;
        for (const auto& cell : cells_) numbers += 1 + cell.size();
        text += fmt::format("CELLS {} {}\n", cells_.size(), numbers);
        for (const auto& cell : cells_) text += fmt::format("{} {}\n", cell.size(), fmt::join(cell, " "));
        text += fmt::format("CELL_TYPES {}\n{}\n", types_.size(), fmt::join(types_, "\n"));
        std::string scalars = "SCALARS p double 1\nLOOKUP_TABLE default\n", vectors = "VECTORS U double\n";
        for (const double value : values_) {
            if (!onCells) break;
            scalars += fmt::format("{}\n", value);
            vectors += fmt::format("{} {} 0\n", value, value == 0 ? 0 : 1);
        }
        for (const glm::dvec3& p : points_) {
            if (onCells) break;
            scalars += fmt::format("{}\n", 10 + p.z);
            vectors += fmt::format("1 0 {}\n", p.z);
        }
        text += fmt::format("{} {}\n", onCells ? "CELL_DATA" : "POINT_DATA", onCells ? cells_.size() : points_.size());
        writeBytes(path, text + scalars + vectors);
    }

private:
    std::vector<glm::dvec3> points_;
    std::vector<std::vector<int>> cells_;
    std::vector<int> types_;
    std::vector<double> values_;
};

class MixedCells : public testing::Test {
protected:
    Scene load(const std::string& surface, const std::string& colorBy = "p") const
    {
        SceneDescription description;
        description.surface.spec = surface;
        description.field.spec = file_;
        description.field.vectors = "U";
        description.shading.colorBy = colorBy;
        return loadScene(description);
    }
    static std::array<float, 2> range(const std::vector<float>& values)
    {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        return {*least, *most};
    }

    const TempFolder folder_;
    const std::string file_ = folder_.file("mixed.vtk");
};

/// Faces of the boundary beside a volume often have zeros.
TEST_F(MixedCells, FacesDoNotCountInAVolumesMeans)
{
    MixedGrid grid;
    grid.addFloor(0);
    grid.add(kLine, {MixedGrid::at(1, 1, 2), MixedGrid::at(2, 1, 2)}, 0);
    grid.write(file_, true);
    for (const char* surface : {"slice:1.5,1.5,1.5:0,0,1", "slice:1.5,1.5,0.1:0,0,1", "boundary"}) {
        const Scene scene = load(surface);
        EXPECT_EQ(range(scene.surface.pointScalars), (std::array{10.f, 10.f})) << surface;
        EXPECT_NEAR(scene.maxVector, std::sqrt(101.0), 1e-5) << surface;
    }
}

TEST_F(MixedCells, EdgesDoNotCountInTheMeansOfFlatData)
{
    MixedGrid grid(0);
    grid.addFloor(10);
    for (int x = 0; x < 3; ++x) grid.add(kLine, {MixedGrid::at(x, 0, 0), MixedGrid::at(x + 1, 0, 0)}, 0);
    grid.write(file_, true);
    EXPECT_EQ(range(load("boundary").surface.pointScalars), (std::array{10.f, 10.f}));
}

/// [points of a height above the roof] Their values.
template <class Value>
std::vector<Value> aboveRoof(const SurfaceMesh& mesh, const std::vector<Value>& values)
{
    std::vector<Value> above;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.originWorld.z + double(mesh.positions[i].z) > 3.01) above.push_back(values[i]);
    return above;
}

TEST_F(MixedCells, ShellsBesideSolidsShowTheirOwnValues)
{
    MixedGrid grid;
    grid.addFin();
    for (const bool onCells : {false, true}) {
        grid.write(file_, onCells);
        const Scene scene = load("boundary");
        const std::vector<float> scalars = aboveRoof(scene.surface, scene.surface.pointScalars);
        ASSERT_GE(scalars.size(), 10u);
        EXPECT_EQ(range(scalars), onCells ? (std::array{101.5f, 105.f}) : (std::array{14.f, 18.f})) << onCells;
        for (const glm::vec3& vector : aboveRoof(scene.surface, scene.surface.pointVectors))
            EXPECT_TRUE(std::isfinite(vector.x) && glm::length(vector) > 0.5f);
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
        EXPECT_TRUE(scene.hasScalar);
        EXPECT_EQ(scene.scalarName, "p");
    }
}

/// Whoever reads the field deals it to the others.
TEST_F(MixedCells, ShellsAreTheSameFromAnyNumberOfRanks)
{
    MixedGrid grid;
    grid.addFin();
    grid.write(file_, false);
    const Scene alone = load("boundary");
    SceneDescription description;
    description.surface.spec = "boundary";
    description.field.spec = file_;
    description.shading.colorBy = "p";
    runRanks(3, [&](Communicator& communicator) {
        const Scene scene = loadOnRank(communicator, description);
        EXPECT_EQ(scene.surface.positions, alone.surface.positions);
        EXPECT_EQ(scene.surface.pointVectors, alone.surface.pointVectors);
        EXPECT_EQ(scene.surface.pointScalars, alone.surface.pointScalars);
    });
}

/// Where a solver wrote the walls of a volume as faces, they are walls like those that it has itself.
TEST_F(MixedCells, FacesOfTheVolumeAreWalls)
{
    MixedGrid grid;
    grid.write(file_, false);
    const std::size_t triangles = load("boundary").surface.triangles.size();
    const std::array<float, 2> scalars = range(load("boundary").surface.pointScalars);
    grid.addFloor(0);
    grid.write(file_, false);
    const Scene scene = load("boundary");
    EXPECT_GT(scene.surface.triangles.size(), triangles);
    EXPECT_EQ(range(scene.surface.pointScalars), scalars);
}

/// Blocks of faces in unstructured grids, as ParaView saves the shells of Exodus.
TEST_F(MixedCells, BlocksOfFacesAreASurfaceAndAField)
{
    std::string blocks;
    for (const char* name : {"near", "far"}) {
        GridSample sheet;
        sheet.dims = {5, 4, 1};
        sheet.origin[2] = name[0] == 'n' ? 0 : 2;
        writeGridFile(folder_.file(std::string(name) + ".vtu"), sheet);
        blocks += fmt::format("<DataSet index=\"{0}\" name=\"{1}\" file=\"{1}.vtu\"/>", name[0] == 'n' ? 0 : 1, name);
    }
    const std::string sheets = folder_.file("sheets.vtm");
    writeBytes(sheets, "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>" + blocks +
                           "</vtkMultiBlockDataSet></VTKFile>");
    SceneDescription asSurface, asField;
    asSurface.surface.spec = sheets;
    asField.surface.spec = "boundary";
    asField.field.spec = sheets;
    for (SceneDescription* description : {&asSurface, &asField}) {
        description->field.vectors = "U";
        description->shading.colorBy = "p";
        const Scene scene = loadScene(*description);
        EXPECT_EQ(scene.surface.triangles.size(), 2u * 2 * 4 * 3);
        EXPECT_TRUE(scene.warnings.empty());
    }
    const FileInfo info = fileInfo(sheets);
    ASSERT_FALSE(info.suggestions.empty());
    EXPECT_NE(info.suggestions[0].find("--surface " + sheets + " --vectors U --color-by p"), std::string::npos)
        << info.suggestions[0];
    EXPECT_EQ(info.text.find("--field"), std::string::npos) << info.text;
}

}  // namespace
}  // namespace aeolic
