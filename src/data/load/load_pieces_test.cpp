#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "aeolic/error.h"
#include "data/load/scene_sizes.h"
#include "data/piece_run.h"
#include "data/vtk/surface/surface_file.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "load_testing.h"
#include "pieces_testing.h"

/// A surface of which every rank holds a piece: together they are the whole, with its bits.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// What is drawn of a triangle.
struct Drawn {
    std::array<glm::vec3, 3> positions, normals, vectors;
    std::array<float, 3> scalars{};
    bool operator==(const Drawn& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};

Drawn drawnOf(const SurfaceMesh& mesh, std::size_t i)
{
    Drawn drawn{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t point = mesh.triangles[i][k];
        drawn.positions[k] = mesh.positions[point];
        drawn.normals[k] = mesh.normals[point];
        if (!mesh.pointVectors.empty()) drawn.vectors[k] = mesh.pointVectors[point];
        if (!mesh.cellVectors.empty()) drawn.vectors[k] = mesh.cellVectors[i];
        if (!mesh.pointScalars.empty()) drawn.scalars[k] = mesh.pointScalars[point];
        if (!mesh.cellScalars.empty()) drawn.scalars[k] = mesh.cellScalars[i];
    }
    return drawn;
}

std::vector<Scene> loadPieces(const SceneDescription& description, int ranks)
{
    const bool fromFile = description.field.spec.empty();
    return loadParts(description, {!fromFile, fromFile}, ranks);
}

void expectPiecesOfTheWhole(const SceneDescription& description, int ranks)
{
    const Scene whole = loadScene(description);
    std::vector<std::pair<std::uint64_t, Drawn>> drawn;
    std::size_t most = 0;
    double radius = 0;
    for (const Scene& part : loadPieces(description, ranks)) {
        ASSERT_TRUE(part.inPieces);
        const SurfaceMesh& mesh = part.surface;
        ASSERT_EQ(mesh.order.size(), mesh.triangles.size());
        EXPECT_TRUE(std::is_sorted(mesh.order.begin(), mesh.order.end()));
        if (!mesh.triangles.empty()) {
            EXPECT_EQ(mesh.originWorld, whole.surface.originWorld);
        }
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) drawn.emplace_back(mesh.order[i], drawnOf(mesh, i));
        most = std::max(most, mesh.triangles.size());
        radius = std::max(radius, part.fitRadius);
    }
    std::stable_sort(drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    ASSERT_EQ(drawn.size(), whole.surface.triangles.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        ASSERT_TRUE(i == 0 || drawn[i - 1].first < drawn[i].first) << "a triangle twice";
        ASSERT_TRUE(drawn[i].second == drawnOf(whole.surface, i)) << "triangle " << i << ", " << ranks << " ranks";
    }
    if (ranks <= 3) {
        EXPECT_LE(most, 2 * drawn.size() / std::size_t(ranks)) << "about as much for each";
    }
}

class LoadPieces : public testing::Test {
protected:
    SceneDescription torus(const TorusPieces& torus, const std::string& colorBy = "q") const
    {
        return describe(writeTorusPieces(folder_.path().string(), "torus", torus), "", colorBy);
    }
    SceneDescription winding(bool masked, const std::string& array = "p=0.1") const
    {
        writeWindingField(folder_.file("f.vti"), masked);
        return describe("isosurface:" + array, folder_.file("f.vti"), "U:mag");
    }
    TempFolder folder_;
};

TEST_F(LoadPieces, OfATorus)
{
    for (const int ranks : {2, 3, 4}) expectPiecesOfTheWhole(torus({}), ranks);
    TorusPieces onCells;
    onCells.onCells = true;
    expectPiecesOfTheWhole(torus(onCells), 3);
}

TEST_F(LoadPieces, MoreRanksThanPiecesLeaveSomeWithNothing)
{
    expectPiecesOfTheWhole(torus({}), 7);
    std::size_t nothing = 0;
    for (const Scene& part : loadPieces(torus({}), 7)) nothing += part.surface.triangles.empty();
    EXPECT_EQ(nothing, 3u);
}

TEST_F(LoadPieces, AnEmptyPieceIsNormal)
{
    TorusPieces some;
    some.empty = {0, 2};
    for (const int ranks : {2, 3, 4}) expectPiecesOfTheWhole(torus(some), ranks);
}

/// VTK puts the strips of all pieces behind the polygons of all.
TEST_F(LoadPieces, StripsComeBehindThePolygonsOfAllPieces)
{
    for (const bool onCells : {false, true}) {
        TorusPieces strips;
        strips.strips = 1;
        strips.onCells = onCells;
        for (const int ranks : {2, 3, 4}) expectPiecesOfTheWhole(torus(strips), ranks);
    }
}

TEST_F(LoadPieces, NormalsComeFromTheFileWhereAllPiecesHaveGoodOnes)
{
    TorusPieces normals;
    normals.normals = true;
    expectPiecesOfTheWhole(torus(normals), 3);
    normals.brokenNormal = 2;
    expectPiecesOfTheWhole(torus(normals), 4);
}

TEST_F(LoadPieces, TrianglesThatCannotBeDrawnAreLeftOut)
{
    TorusPieces bad;
    bad.noArea = 1;
    bad.notFinite = 2;
    expectPiecesOfTheWhole(torus(bad), 4);
}

TEST_F(LoadPieces, OfAnIsosurface)
{
    for (const bool masked : {false, true})
        for (const int ranks : {2, 3, 5, 8, 13}) expectPiecesOfTheWhole(winding(masked), ranks);
    expectPiecesOfTheWhole(winding(false, "U:mag=1.3"), 5);
}

TEST_F(LoadPieces, AnIsosurfaceOfMoreRanksThanCells)
{
    GridSample sample;
    sample.dims = {3, 3, 2};
    writeGridFile(folder_.file("small.vti"), sample);
    expectPiecesOfTheWhole(describe("isosurface:p=30", folder_.file("small.vti"), "U:mag"), 7);
}

TEST_F(LoadPieces, OfAParallelImageFile)
{
    writeGridFile(folder_.file("a.pvti"));
    for (const int ranks : {2, 5})
        expectPiecesOfTheWhole(describe("isosurface:p=104", folder_.file("a.pvti"), "p"), ranks);
}

TEST_F(LoadPieces, ABrickHoldsOneLayerMoreAllAroundForItsPiece)
{
    const SceneDescription description = winding(false);
    SceneDescription slice = description;
    slice.surface.spec = "slice:10,-6,3.5:0,0,1";
    const std::vector<Scene> slices = loadPieces(slice, 8), pieces = loadPieces(description, 8);
    for (std::size_t rank = 0; rank < 8; ++rank) {
        const GridField& field = *pieces[rank].field;
        EXPECT_EQ(*field.brick, slices[rank].field->brick->grown(field.dims));
        EXPECT_FALSE(slices[rank].inPieces) << "a slice is coarse, and every rank's";
    }
}

TEST_F(LoadPieces, BytesAreThoseOfTheFilesThatCanBeDealt)
{
    SceneDescription description = torus({});
    std::uint64_t bytes = 0;
    for (int i = 0; i < 4; ++i)
        bytes += std::filesystem::file_size(folder_.file("torus_" + std::to_string(i) + ".vtp"));
    EXPECT_EQ(pieceFileBytesOf(description), bytes);
    description.surface.spec = folder_.file("torus_1.vtp");
    EXPECT_EQ(pieceFileBytesOf(description), 0u) << "a single file";
    description.surface.spec = folder_.file("t_*.pvtp");
    writeTorusPieces(folder_.path().string(), "t_1", {});
    writeTorusPieces(folder_.path().string(), "t_2", {});
    EXPECT_EQ(pieceFileBytesOf(description), 4 * bytes) << "two steps, the moment between them, one step read ahead";
    TorusPieces one;
    one.pieces = 1;
    EXPECT_EQ(pieceFileBytesOf(torus(one)), 0u);
    EXPECT_EQ(pieceFileBytesOf(winding(false)), 0u);
    EXPECT_EQ(pieceFileBytesOf(describe("teapot", "abc", "")), 0u);
}

TEST(DealtPieces, RunsOfAboutEqualBytes)
{
    const std::vector<std::uint64_t> bytes{10, 10, 10, 70, 10, 10};
    const auto runs = [&](int ranks) {
        std::vector<PieceRun> all;
        for (int rank = 0; rank < ranks; ++rank) all.push_back(runOf({rank, ranks}, bytes));
        return all;
    };
    EXPECT_EQ(runs(1), (std::vector<PieceRun>{{0, 6}}));
    EXPECT_EQ(runs(2), (std::vector<PieceRun>{{0, 3}, {3, 6}}));
    for (const int ranks : {3, 5, 8, 13}) {
        int next = 0;
        for (const PieceRun& run : runs(ranks)) {
            EXPECT_EQ(run.begin, next);
            EXPECT_GE(run.end, run.begin);
            next = run.end;
        }
        EXPECT_EQ(next, 6) << ranks << " ranks";
    }
}

}  // namespace
}  // namespace aeolic
