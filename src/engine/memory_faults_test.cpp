#include <gtest/gtest.h>

#include "memory_scenes_testing.h"

/// Wrong data in the caller's memory are refused as files are.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

TEST_F(MemoryTest, WrongSurfacesGetAFilesWords)
{
    const MemorySheet sheet(4);
    const auto changed = [&](const auto& change) {
        Surface surface = sheet.surface();
        change(surface);
        return complaint({surface, {}});
    };
    scene_.field.vectors = "tau";
    EXPECT_EQ(complaint({Surface{}, {}}), "surface in memory: no array 'tau'; expected one of: none");
    EXPECT_EQ(changed([](Surface& s) { s.pointArrays[0].values.count = 7; }),
              "surface in memory: array 'tau' has 7 values; expected 25, one for each of the points");
    EXPECT_EQ(changed([](Surface& s) { s.cellArrays[0].values.count = 7; }),
              "surface in memory: array 'cellTau' has 7 values; expected 16, one for each of the cells");
    EXPECT_EQ(changed([](Surface& s) { s.points.count = 24; }),
              "surface in memory: polygon 15 refers to point 24, which does not exist; expected points from 0 to 23");
    EXPECT_EQ(changed([](Surface& s) { s.points.components = 2; }),
              "surface in memory: points: 2 components; expected 3");
    EXPECT_EQ(changed([](Surface& s) { s.points.data = nullptr; }),
              "surface in memory: points: a null pointer; expected values");
    EXPECT_EQ(changed([](Surface& s) { s.points.type = ValueType::int32; }),
              "surface in memory: points: whole numbers; expected float or double");
    EXPECT_EQ(changed([](Surface& s) { s.points.strideBytes = 8; }),
              "surface in memory: points: tuples 8 bytes apart; expected at least 12, what a tuple takes");
    EXPECT_EQ(changed([](Surface& s) { s.connectivity.type = ValueType::float64; }),
              "surface in memory: connectivity: indices that are not int32, uint32 or int64; expected whole numbers");
    EXPECT_EQ(changed([](Surface& s) { s.connectivity = {}; }),
              "surface in memory: connectivity: it is empty; expected 64 indices, as the offsets say");
    EXPECT_EQ(changed([](Surface& s) { s.connectivity.count = 0; }),
              "surface in memory: connectivity: it is empty; expected 64 indices, as the offsets say");
    EXPECT_EQ(changed([](Surface& s) { s.offsets = {}; }),
              "surface in memory: offsets: they are empty; expected where each polygon begins, and 64 at the end");
    EXPECT_EQ(changed([](Surface& s) { s.offsets.count = 16; }),
              "surface in memory: offsets: they do not rise from 0 to the number of indices; expected where each "
              "polygon begins, and 64 at the end");
    EXPECT_EQ(changed([](Surface& s) { s.triangles = ArrayView(static_cast<const std::int32_t*>(nullptr), 4, 3); }),
              "surface in memory: triangles and polygons; expected one or the other");
    EXPECT_EQ(changed([](Surface& s) { s.pointArrays[1].name = "tau"; }),
              "surface in memory: array 'tau' is given twice; expected each name once");
    EXPECT_EQ(changed([](Surface& s) { s.offsets = s.connectivity = {}, s.cellArrays.clear(); }),
              "surface in memory: 25 points, 0 lines and no polygons; expected a surface of at least one triangle");
    scene_.field.vectors = "tua";
    EXPECT_EQ(
        complaint({sheet.surface(), {}}),
        "surface in memory: no array 'tua'; expected one of: tau (points, 3 components), q (points, 1 component), "
        "cellTau (cells, 3 components), cellQ (cells, 1 component); did you mean tau?");
    scene_.field.vectors = "tau";
    scene_.shading.colorBy = "heat";
    EXPECT_EQ(complaint({sheet.surface(), {}}).substr(0, 55),
              "surface in memory: no array 'heat' to colour by; expect");
    MemorySheet nowhere(2);
    for (float& c : nowhere.points) c = kNan;
    scene_.shading.colorBy = "";
    EXPECT_EQ(complaint({nowhere.surface(), {}}),
              "surface in memory: all 4 cells have a corner that is not finite; expected finite coordinates");
}

TEST_F(MemoryTest, WrongGridsGetAFilesWords)
{
    const MemoryGrid grid;
    const auto changed = [&](const auto& change) {
        Grid other = grid.grid();
        change(other);
        return complaint({{}, other});
    };
    EXPECT_EQ(changed([](Grid& g) {
                  g.dims = {0, 0, 0}, g.pointArrays.clear();
              }),
              "grid in memory: 0 points and 0 cells; expected a grid with cells");
    EXPECT_EQ(changed([](Grid& g) { g.dims[0] = 8; }),
              "grid in memory: array 'U' has 504 values; expected 448, one for each of the points");
    EXPECT_EQ(changed([](Grid& g) { g.dims[0] = -9; }),
              "grid in memory: -9 x 8 x 7 samples; expected how many there are in x, y and z");
    EXPECT_EQ(changed([](Grid& g) { g.spacing[1] = 0; }),
              "grid in memory: its spacing is 0.25,0,0.25; expected positive numbers");
    EXPECT_EQ(changed([](Grid& g) { g.origin[2] = kNan; }),
              "grid in memory: its origin is -1,-0.5,nan; expected finite numbers");
    EXPECT_EQ(changed([](Grid& g) { g.pointArrays.erase(g.pointArrays.begin()); }),
              "grid in memory: no array of vectors; expected an array of 3 components; there are: p (points, 1 "
              "component)");
    EXPECT_EQ(changed([](Grid& g) {
                  g.origin = {100, 0, 0};
              }).substr(0, 61),
              "grid in memory: the field, from 100,0,0 to 102,1.75,1.5, does");
}

}  // namespace
}  // namespace aeolic
