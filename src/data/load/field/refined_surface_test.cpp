#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "data/cells/refine.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"

/// How finely a surface is cut where the field's cells are damaged.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class RefinedSurface : public testing::Test {
protected:
    SceneDescription describe() const
    {
        SceneDescription description;
        description.surface.spec = wall_;
        description.field.spec = flow_;
        return description;
    }

    TempFolder folder_;
    const std::string wall_ = folder_.file("wall.vtk"), flow_ = folder_.file("flow.vtk");
};

TEST_F(RefinedSurface, AFewCellsOfWildSizesDoNotMakeMillionsOfTriangles)
{
    // Points that are read from a wrong place of a file look like these: most coordinates are 0, others are anything.
    constexpr unsigned kPoints = 60, kCells = 120;
    std::mt19937 random(3);
    for (int file = 0; file < 12; ++file) {
        std::string points, vectors, corners, types;
        for (unsigned i = 0; i < 3 * kPoints; ++i) {
            const int exponent = int(random() % 120) - 60;
            points += fmt::format("{}\n", random() % 5 != 0 ? 0.0 : std::ldexp(random() % 2 != 0 ? 1 : -1, exponent));
        }
        for (unsigned i = 0; i < kPoints; ++i) vectors += "1 0.5 0.2\n";
        for (unsigned i = 0; i < kCells; ++i) {
            const auto corner = [&] { return unsigned(random() % kPoints); };
            corners += fmt::format("4 {} {} {} {}\n", corner(), corner(), corner(), corner());
            types += "10\n";
        }
        writeBytes(flow_, fmt::format("# vtk DataFile Version 3.0\nwild\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                                      "POINTS {0} double\n{1}CELLS {2} {3}\n{4}CELL_TYPES {2}\n{5}"
                                      "POINT_DATA {0}\nVECTORS U double\n{6}",
                                      kPoints, points, kCells, 5 * kCells, corners, types, vectors));
        SceneDescription description = describe();
        description.surface.spec = "boundary";
        // Each cell has four sides at most.
        EXPECT_LE(loadScene(description).surface.triangles.size(), mostRefinedTriangles(kCells, 4 * kCells)) << file;
    }
}

TEST_F(RefinedSurface, ACellFarBelowRoundingMakesFewTriangles)
{
    // The far cell makes the whole wall as near to the small one as rounding is. At its size, the wall would have 2^24.
    const double small = 0x1p-35;
    writeBytes(flow_, fmt::format("# vtk DataFile Version 3.0\ntwo cells\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                                  "POINTS 8 double\n0 0 0 {0} 0 0 0 {0} 0 0 0 {0} 1 0 0 2 0 0 1 1 0 1 0 1\n"
                                  "CELLS 2 10\n4 0 1 2 3\n4 4 5 6 7\nCELL_TYPES 2\n10\n10\n"
                                  "POINT_DATA 8\nVECTORS U double\n{1}{1}{1}{1}{1}{1}{1}{1}",
                                  small, "1 0.5 0.2\n"));
    writeBytes(wall_, fmt::format("# vtk DataFile Version 3.0\na wall\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n"
                                  "0 0 0 {0} 0 0 0 {0} 0\nPOLYGONS 1 4\n3 0 1 2\n",
                                  4096 * small));
    EXPECT_LT(loadScene(describe()).surface.triangles.size(), 1000u);
}

}  // namespace
}  // namespace aeolic
