#include "reader/openfoam/foam_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "data/vtk/testing/sample_files.h"
#include "reader/openfoam/testing/sample_case.h"

/// Where triangles lie at the same depth the picture shows the first one, so it depends on the order of a case's faces.
namespace aeolic {
namespace {

using Polygon = std::vector<glm::dvec3>;

struct Read {
    std::vector<Polygon> polygons;
    std::vector<std::uint64_t> places;
};

/// Floor and roof, asked for in this order or the other one. `run`: of these processors alone.
Read readWalls(const std::string& path, bool roofFirst, std::optional<PieceRun> run = {})
{
    const FoamCase foam = findFoamCase(path);
    const double time = foam.times.back();
    std::vector<FoamPart> walls;
    for (const FoamPart& patch : foamPatches(foam, time))
        if (patch.type == "wall") walls.push_back(patch);
    EXPECT_EQ(walls.size(), 2u);
    if (roofFirst) std::reverse(walls.begin(), walls.end());
    const PartMesh mesh = readFoamPatches(foam, walls, time, {}, run.value_or(PieceRun{0, int(foam.folders.size())}));
    Read read;
    read.places = mesh.places;
    auto corner = mesh.cells.front().corners.begin();
    for (const std::int64_t size : mesh.cells.front().sizes) {
        Polygon& polygon = read.polygons.emplace_back();
        for (std::int64_t k = 0; k < size; ++k) polygon.push_back((*mesh.points)[std::size_t(*corner++)]);
    }
    return read;
}

bool isAscending(const std::vector<std::uint64_t>& places)
{
    return std::is_sorted(places.begin(), places.end());
}

TEST(FoamSurface, FacesComeInTheOrderOfTheMeshWhateverIsAskedForFirst)
{
    const test::TempFolder folder;
    test::writeSampleCase(folder.file("case"));
    const Read read = readWalls(folder.file("case"), false);
    ASSERT_EQ(read.polygons.size(), 2u * test::kSampleFloorFaces);
    EXPECT_EQ(readWalls(folder.file("case"), true).polygons, read.polygons);
}

TEST(FoamSurface, ProcessorsFacesComeInTheOrderOfTheWholeMesh)
{
    const test::TempFolder folder;
    test::writeSampleCase(folder.file("whole"));
    test::writeSampleCase(folder.file("parts"), {.processors = 3});
    const Read whole = readWalls(folder.file("whole"), false), parts = readWalls(folder.file("parts"), false);
    EXPECT_EQ(parts.polygons, whole.polygons);
    EXPECT_TRUE(isAscending(parts.places));
    EXPECT_EQ(std::adjacent_find(parts.places.begin(), parts.places.end()), parts.places.end()) << "each has its own";
}

TEST(FoamSurface, WithoutAddressingProcessorsFollowOneAnother)
{
    const test::TempFolder folder;
    test::writeSampleCase(folder.file("case"), {.processors = 3});
    for (int i = 0; i < 3; ++i)
        std::filesystem::remove(folder.path() / "case" / ("processor" + std::to_string(i)) /
                                "constant/polyMesh/faceProcAddressing");
    const Read read = readWalls(folder.file("case"), false);
    ASSERT_EQ(read.polygons.size(), 2u * test::kSampleFloorFaces);
    EXPECT_TRUE(isAscending(read.places));
    std::vector<Polygon> oneAfterAnother;
    for (int i = 0; i < 3; ++i)
        for (const Polygon& polygon : readWalls(folder.file("case"), false, PieceRun{i, i + 1}).polygons)
            oneAfterAnother.push_back(polygon);
    EXPECT_EQ(read.polygons, oneAfterAnother);
}

}  // namespace
}  // namespace aeolic
