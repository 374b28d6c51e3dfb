#include "data/cells/cell_heights.h"

#include <gtest/gtest.h>

#include "data/cells/testing/volume_testing.h"

namespace aeolic {
namespace {

using namespace testing_volumes;

/// A cell over the square from 0 to 1 on z = 0. The side that meets it in the line x = 0 leans outwards by 45 degrees.
/// `turned`: the leaning side comes before the square among the faces, else behind it.
VolumeCells leaningCell(bool turned)
{
    VolumeCells cells;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const int x = turned ? k : i, z = turned ? i : k;
                cells.points.emplace_back(x == 0 ? -z : x, j, z);
            }
    addHexahedron(cells, Shape::hexahedron, {0, 1, 3, 2, 4, 5, 7, 6});
    return cells;
}

/// On the line where both faces meet neither is nearer.
TEST(CellHeights, OfFacesEquallyNearTheMostParallelCounts)
{
    const glm::dvec3 onLine(0, 0.5, 0);
    for (const bool turned : {false, true}) {
        const VolumeCells cells = leaningCell(turned);
        EXPECT_DOUBLE_EQ(heightOver(cells, 0, onLine, {0, 0, 1}, 1e-6), 1) << turned;
        // The other way round: over the leaning side the cell is as high as its farthest edge.
        EXPECT_DOUBLE_EQ(heightOver(cells, 0, onLine, glm::normalize(glm::dvec3(1, 0, 1)), 1e-6), std::sqrt(2.0))
            << turned;
    }
}

}  // namespace
}  // namespace aeolic
