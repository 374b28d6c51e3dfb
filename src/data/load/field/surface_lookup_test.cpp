#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/blank_surface.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Direction of the flow at the wall y = 0, and of the wall's shear.
double angleAt(double x)
{
    return 0.5 * std::sin(4 * x);
}

struct Layer {
    glm::ivec3 dims{17, 25, 9};
    double slip = 0;
    bool onCells = false;
    bool stretched = true;
    double strength = 1;
    double maskedBelow = -1;
};

/// A channel over the wall y = 0, with U and p. Without slip, and thin cells at the wall, unless told otherwise.
void writeLayer(const std::string& path, const Layer& layer = {})
{
    std::string points, vectors, scalars;
    const auto add = [&](double x, double y, double z) {
        const double angle = angleAt(x) + 1.5 * y, speed = layer.strength * (layer.slip + 1 - std::exp(-20 * y));
        if (y < layer.maskedBelow)
            vectors += "nan 0 0\n";
        else
            vectors += fmt::format("{} 0 {}\n", speed * std::cos(angle), speed * std::sin(angle));
        scalars += fmt::format("{}\n", x + 10 * z);
    };
    const glm::ivec3 n = layer.dims;
    const auto height = [&](double j) {
        const double t = j / (n.y - 1);
        return layer.stretched ? 1e-3 * (std::exp(t * std::log(1001.0)) - 1) : t;
    };
    for (int k = 0; k < n.z; ++k)
        for (int j = 0; j < n.y; ++j)
            for (int i = 0; i < n.x; ++i) {
                const double x = double(i) / (n.x - 1), z = double(k) / (n.z - 1);
                points += fmt::format("{} {} {}\n", x, height(j), z);
                if (!layer.onCells) add(x, height(j), z);
            }
    for (int k = 0; layer.onCells && k < n.z - 1; ++k)
        for (int j = 0; j < n.y - 1; ++j)
            for (int i = 0; i < n.x - 1; ++i)
                add((i + 0.5) / (n.x - 1), 0.5 * (height(j) + height(j + 1)), (k + 0.5) / (n.z - 1));
    const int values = layer.onCells ? (n.x - 1) * (n.y - 1) * (n.z - 1) : n.x * n.y * n.z;
    const std::string head = "# vtk DataFile Version 3.0\na channel\nASCII\n";
    const std::string grid =
        layer.stretched
            ? fmt::format("DATASET STRUCTURED_GRID\nDIMENSIONS {} {} {}\nPOINTS {} double\n{}", n.x, n.y, n.z,
                          n.x * n.y * n.z, points)
            : fmt::format("DATASET STRUCTURED_POINTS\nDIMENSIONS {} {} {}\nORIGIN 0 0 0\nSPACING {} {} {}\n", n.x, n.y,
                          n.z, 1.0 / (n.x - 1), 1.0 / (n.y - 1), 1.0 / (n.z - 1));
    writeBytes(path, head + grid +
                         fmt::format("{} {}\nVECTORS U double\n{}SCALARS p double 1\nLOOKUP_TABLE default\n{}",
                                     layer.onCells ? "CELL_DATA" : "POINT_DATA", values, vectors, scalars));
}

/// The wall as two triangles, of which `lift` is the height; `turned`: with normals into the wall.
void writeWall(const std::string& path, double lift = 0, bool turned = false)
{
    writeBytes(path, fmt::format("# vtk DataFile Version 3.0\na wall\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
                                 "0 {0} 0 1 {0} 0 1 {0} 1 0 {0} 1\nPOLYGONS 1 5\n4 {1}\n",
                                 lift, turned ? "0 1 2 3" : "0 3 2 1"));
}

class CellsOnSurface : public testing::Test {
protected:
    CellsOnSurface() { writeWall(wall_); }

    SceneDescription describe(const std::string& colorBy = "") const
    {
        SceneDescription description;
        description.surface.spec = wall_;
        description.field.spec = flow_;
        description.shading.colorBy = colorBy;
        return description;
    }
    static double streaked(const Scene& scene)
    {
        const BlankAreas areas = blankAreasOf(scene, {});
        return double(areas.within - areas.masked - areas.still - areas.across) / double(areaOf(scene));
    }
    /// Degrees between the vectors and the flow at the wall, in rising order.
    static std::vector<double> errors(const Scene& scene)
    {
        std::vector<double> all;
        const SurfaceMesh& mesh = scene.surface;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 v = mesh.pointVectors[i];
            const double truth = angleAt(mesh.originWorld.x + double(mesh.positions[i].x));
            const double angle = std::remainder(std::atan2(double(v.z), double(v.x)) - truth, 2 * std::numbers::pi);
            all.push_back(glm::length(v) > 0 ? std::abs(angle) * 180 / std::numbers::pi : 180);
        }
        std::sort(all.begin(), all.end());
        return all;
    }
    static void expectWallFlow(const Scene& scene)
    {
        EXPECT_FALSE(scene.field);
        EXPECT_GE(streaked(scene), 0.95);
        const std::vector<double> all = errors(scene);
        ASSERT_GT(all.size(), 100u);
        EXPECT_LE(all[all.size() / 2], 1);
        EXPECT_LE(all[all.size() * 99 / 100], 5);
    }

    const TempFolder folder_;
    const std::string wall_ = folder_.file("wall.vtk"), flow_ = folder_.file("flow.vtk");
};

TEST_F(CellsOnSurface, WallsFromOneFileVelocityFromAnotherWithoutSlip)
{
    writeLayer(flow_);
    const Scene scene = loadScene(describe("p"));
    expectWallFlow(scene);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    EXPECT_NEAR(scene.scalarRange[0], 0, 1e-4);
    EXPECT_NEAR(scene.scalarRange[1], 11, 1e-4);
}

TEST_F(CellsOnSurface, NormalsIntoTheWallAndValuesInCells)
{
    writeWall(wall_, 0, true);
    writeLayer(flow_);
    expectWallFlow(loadScene(describe()));
    Layer cells;
    cells.onCells = true;
    writeLayer(flow_, cells);
    expectWallFlow(loadScene(describe()));
}

TEST_F(CellsOnSurface, TheBoundaryOfAVolumeHasFlowAtItsWalls)
{
    writeLayer(flow_);
    SceneDescription description = describe();
    description.surface.spec = "boundary";
    const Scene scene = loadScene(description);
    for (std::size_t i = 0; i < scene.surface.positions.size(); ++i)
        if (std::abs(scene.surface.normals[i].y) > 0.99f && glm::length(scene.surface.pointVectors[i]) == 0)
            ADD_FAILURE() << "no flow at point " << i;
}

TEST_F(CellsOnSurface, RanksAndPiecesHaveTheSameVectors)
{
    writeLayer(flow_);
    const SceneDescription description = describe("U:mag");
    const Scene whole = loadScene(description);
    for (const int ranks : {2, 3})
        for (const Scene& part : loadParts(description, {}, ranks)) EXPECT_EQ(fingerprint(part), fingerprint(whole));
}

TEST_F(CellsOnSurface, TheWallsShearIsTheChangeWithTheDistance)
{
    writeLayer(flow_);
    SceneDescription description = describe("wallShear(U):mag");
    description.field.vectors = "wallShear(U)";
    const Scene scene = loadScene(description);
    expectWallFlow(scene);
    EXPECT_EQ(scene.scalarName, "|wallShear(U)|");
    EXPECT_NEAR(scene.scalarRange[0], 20, 0.2);  // The slope of 1 - exp(-20 y).
    EXPECT_NEAR(scene.scalarRange[1], 20, 0.2);
    SceneDescription slice = description;
    slice.surface.spec = "slice:0.5,0.5,0.5:0,0,1";
    EXPECT_THROW(loadScene(slice), InputError);
    SceneDescription atWall = description;
    atWall.field.offset = 0;
    EXPECT_THROW(loadScene(atWall), InputError) << "a change over no distance";
    Layer cells;
    cells.onCells = true;  // The wall is at rest, though no value says so.
    writeLayer(flow_, cells);
    const Scene ofCells = loadScene(description);
    expectWallFlow(ofCells);
    EXPECT_NEAR(ofCells.scalarRange[0], 20, 0.2);
    EXPECT_NEAR(ofCells.scalarRange[1], 20, 0.2);
}

TEST_F(CellsOnSurface, AUniformGridIsSampledAtPixelsWhereThereIsFlow)
{
    Layer slips;
    slips.stretched = false;
    slips.slip = 0.5;
    writeLayer(flow_, slips);
    EXPECT_TRUE(loadScene(describe()).field);
    slips.slip = 0;
    writeLayer(flow_, slips);
    const Scene scene = loadScene(describe("U:mag"));
    EXPECT_FALSE(scene.field);
    EXPECT_GE(streaked(scene), 0.95);
    EXPECT_GT(scene.scalarRange[0], 0.1);
}

TEST_F(CellsOnSurface, ABodyMasksTheCellsAtItsOwnWall)
{
    for (const bool stretched : {true, false}) {
        Layer layer;
        layer.stretched = stretched;
        layer.maskedBelow = stretched ? 5e-4 : 0.06;  // Two layers of points.
        writeLayer(flow_, layer);
        const Scene scene = loadScene(describe());
        EXPECT_FALSE(scene.field);
        EXPECT_GE(streaked(scene), 0.95) << stretched;
    }
}

TEST_F(CellsOnSurface, AnOffsetWorksForEveryGrid)
{
    for (const bool stretched : {true, false}) {
        Layer layer;
        layer.stretched = stretched;
        writeLayer(flow_, layer);
        SceneDescription description = describe("U:mag");
        description.field.offset = 0.2;
        const Scene scene = loadScene(description);
        EXPECT_NEAR(scene.scalarRange[1], 1 - std::exp(-4), 0.02) << stretched;
        description.field.offset = -0.2;
        EXPECT_THROW(loadScene(description), InputError) << "nothing is below the wall";
        description.field.offset = 1e30;
        EXPECT_THROW(loadScene(description), InputError);
    }
}

TEST_F(CellsOnSurface, AFieldThatDoesNotTouchTheSurfaceIsRefused)
{
    writeLayer(flow_);
    writeWall(wall_, 5);
    try {
        loadScene(describe());
        ADD_FAILURE();
    } catch (const InputError& wrong) {
        EXPECT_NE(std::string(wrong.what()).find("does not meet the surface"), std::string::npos) << wrong.what();
    }
}

TEST_F(CellsOnSurface, TheFieldMayMoveAndTheSurfaceStay)
{
    Layer layer;
    writeLayer(folder_.file("f_0.vtk"), layer);
    layer.strength = 3;
    writeLayer(folder_.file("f_1.vtk"), layer);
    SceneDescription description = describe("U:mag");
    description.field.spec = folder_.file("f_%d.vtk");
    OneRank alone;
    LoadedScene loaded(description, {}, alone);
    const std::vector<glm::vec3> first = loaded.scene().surface.pointVectors;
    const SceneChange change = loaded.moveTo(0.5);
    EXPECT_TRUE(change.surface);
    EXPECT_FALSE(change.triangles);
    const std::vector<glm::vec3>& between = loaded.scene().surface.pointVectors;
    ASSERT_EQ(between.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        EXPECT_LT(glm::length(between[i] - 2.0f * first[i]), 1e-5f) << "halfway from 1 to 3";
}

std::vector<std::string> warningsWith(const std::vector<std::string>& warnings, const std::string& part)
{
    std::vector<std::string> found;
    for (const std::string& line : warnings)
        if (line.find(part) != std::string::npos) found.push_back(line);
    return found;
}

/// A sheet of its own vectors, whose uses say why nothing is seen.
void writeSheet(const std::string& path, const std::string& vector)
{
    std::string vectors;
    for (int i = 0; i < 4; ++i) vectors += vector + "\n";
    writeBytes(path,
               "# vtk DataFile Version 3.0\na sheet\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n"
               "0 0 0 1 0 0 1 1 0 0 1 0 5 0 0 5.5 0 0 5.5 0.5 0 5 0.5 0\nPOLYGONS 2 10\n4 0 1 2 3\n4 4 5 6 7\n"
               "POINT_DATA 8\nVECTORS U double\n" +
                   vectors + "1 0 0\n1 0 0\n1 0 0\n1 0 0\n");
}

TEST_F(CellsOnSurface, BlankBecauseTheVectorsAreZero)
{
    writeSheet(wall_, "0 0 0");
    SceneDescription description = describe();
    description.field.spec.clear();
    EXPECT_EQ(warningsWith(loadScene(description).warnings,
                           "80 % of the surface has no streaks, mostly because the "
                           "vectors are zero")
                  .size(),
              1u);
}

TEST_F(CellsOnSurface, BlankBecauseTheVectorsAreMasked)
{
    writeSheet(wall_, "nan 0 0");
    SceneDescription description = describe();
    description.field.spec.clear();
    EXPECT_EQ(warningsWith(loadScene(description).warnings, "mostly because the vectors are masked").size(), 1u);
}

TEST_F(CellsOnSurface, BlankBecauseTheVectorsAreAlongTheNormal)
{
    writeSheet(wall_, "0 0 2");
    SceneDescription description = describe();
    description.field.spec.clear();
    EXPECT_EQ(warningsWith(loadScene(description).warnings, "mostly because the vectors are along its normal").size(),
              1u);
    writeSheet(wall_, "0 1 2");
    EXPECT_TRUE(loadScene(description).warnings.empty());
}

TEST_F(CellsOnSurface, BlankBecauseTheSurfaceIsOutsideTheField)
{
    writeSheet(wall_, "0 0 0");
    for (const bool stretched : {true, false}) {
        Layer layer;
        layer.slip = 1;
        layer.stretched = stretched;
        writeLayer(flow_, layer);
        writeBytes(wall_,
                   "# vtk DataFile Version 3.0\na sheet\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
                   "0 0.5 0 9 0.5 0 9 0.5 1 0 0.5 1\nPOLYGONS 1 5\n4 0 1 2 3\n");
        const SceneDescription description = describe();
        const std::vector<std::string> warnings = loadScene(description).warnings;
        EXPECT_EQ(warningsWith(warnings, "mostly because it is outside the field").size(), 1u) << stretched;
        for (const Scene& part : loadParts(description, {}, 3)) EXPECT_EQ(part.warnings, warnings);
    }
}

TEST_F(CellsOnSurface, BlanksAreCountedAlikeInBricks)
{
    writeSheet(wall_, "0 0 0");
    SceneDescription description = describe();
    description.field.spec = folder_.file("a.vti");
    GridSample sample;
    sample.origin = {4.5, -0.5, -0.25};  // Around the smaller square alone.
    writeGridFile(folder_.file("a.vti"), sample);
    const std::vector<std::string> warnings = loadScene(description).warnings;
    EXPECT_EQ(warningsWith(warnings, "of the surface has no streaks").size(), 1u);
    Split split;
    split.field = true;
    for (const int ranks : {2, 3, 5})
        for (const Scene& part : loadParts(description, split, ranks))
            EXPECT_EQ(warningsWith(part.warnings, "streaks"), warningsWith(warnings, "streaks"));
}

}  // namespace
}  // namespace aeolic
