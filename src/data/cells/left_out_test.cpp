#include "data/cells/left_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/cells/near_surface.h"

namespace aeolic {
namespace {

constexpr double kDiagonals = 1.5, kInfinite = std::numeric_limits<double>::infinity();

struct Cell {
    glm::dvec3 middle;
    double diagonal;
};

/// Two triangles, with x and y from 0 to 10.
SurfaceMesh square(double z)
{
    SurfaceMesh mesh;
    mesh.originWorld = {0, 0, z};
    mesh.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    return mesh;
}

/// Cubes in a room 10 wide. Those above a height have sides of 1, those below a half.
std::vector<Cell> cubes(double below)
{
    std::vector<Cell> cells;
    for (const double side : {0.5, 1.0})
        for (double z = side / 2; z < 10; z += side)
            for (double y = side / 2; y < 10; y += side)
                for (double x = side / 2; x < 10; x += side)
                    if ((z < below) == (side < 1)) cells.push_back({{x, y, z}, std::sqrt(3.0) * side});
    return cells;
}

/// The cells that are farther from the mesh than kDiagonals of their diagonals, and how far each is.
struct Others {
    LeftOut leftOut;
    std::vector<std::pair<double, double>> distancesAndDiagonals;

    Others(const std::vector<Cell>& cells, const SurfaceMesh& mesh)
    {
        Bounds bounds;
        for (const Cell& cell : cells) bounds.add(cell.middle);
        leftOut = LeftOut(bounds, cells.size());
        const SurfaceZone zone(mesh, {});
        for (const Cell& cell : cells) {
            double squared = kInfinite;
            for (const auto& triangle : zone.triangles)
                squared = std::min(squared, distanceSquared(cell.middle, triangle));
            const double distance = std::sqrt(squared);
            if (distance <= kDiagonals * cell.diagonal) continue;
            leftOut.add(cell.middle, cell.diagonal);
            distancesAndDiagonals.emplace_back(distance, cell.diagonal);
        }
    }
};

}  // namespace

TEST(CellsLeftOut, NoneIsLeftOut)
{
    const LeftOut leftOut;
    EXPECT_EQ(leftOut.least(), kInfinite);
    EXPECT_EQ(leftOut.leastIn({glm::dvec3(-1), glm::dvec3(1)}), kInfinite);
    EXPECT_FALSE(leftOut.mayLack(square(0), std::vector<double>(4, 1e9), kDiagonals));
}

/// The reach is more than half of the small cells' diagonal, but less than half of the large ones'. The small ones
/// matter where they are beside the surface, not where they are far away.
TEST(CellsLeftOut, OnlyThoseNearbyMatter)
{
    const std::vector<Cell> cells = cubes(4);
    const SurfaceMesh top = square(10), bottom = square(0);
    const double reach = 0.3 * std::sqrt(3.0);
    EXPECT_FALSE(Others(cells, top).leftOut.mayLack(top, std::vector<double>(4, reach), kDiagonals));
    EXPECT_TRUE(Others(cells, bottom).leftOut.mayLack(bottom, std::vector<double>(4, reach), kDiagonals));
}

TEST(CellsLeftOut, NothingThatIsNeededIsOverlooked)
{
    int lacking = 0, complete = 0;
    for (const double below : {0.0, 3.0, 5.0, 9.0})
        for (const double z : {0.0, 2.0, 6.0, 10.0}) {
            const SurfaceMesh mesh = square(z);
            const Others others(cubes(below), mesh);
            for (const double reach : {0.1, 0.43, 0.44, 0.6, 0.86, 0.87, 1.0, 1.2, 1.5, 2.0, 3.0}) {
                const bool lacks = std::any_of(others.distancesAndDiagonals.begin(), others.distancesAndDiagonals.end(),
                                               [&](const auto& cell) { return cell.first <= reach + cell.second; });
                const bool may = others.leftOut.mayLack(mesh, std::vector<double>(4, reach), kDiagonals);
                EXPECT_TRUE(may || !lacks) << below << " " << z << " " << reach;
                lacking += lacks;
                complete += !may;
            }
        }
    EXPECT_GT(lacking, 20);
    EXPECT_GT(complete, 20);
}

TEST(CellsLeftOut, RunsCountInAllOfTheirBox)
{
    LeftOut leftOut({glm::dvec3(0), glm::dvec3(10)}, 1 << 16);
    leftOut.add(CellTree::Box{{2, 2, 2}, {4, 2, 2}}, 0.25);
    EXPECT_EQ(leftOut.leastIn({{3, 2, 2}, {3, 2, 2}}), 0.25);
    EXPECT_EQ(leftOut.leastIn({{8, 8, 8}, {9, 9, 9}}), kInfinite);
    EXPECT_EQ(leftOut.leastIn({glm::dvec3(-100), glm::dvec3(100)}), 0.25);
    leftOut.addAnywhere(0.5);
    EXPECT_EQ(leftOut.leastIn({{8, 8, 8}, {9, 9, 9}}), 0.5);
    EXPECT_EQ(leftOut.least(), 0.25);
}

/// Files may have their cells in any order. What is all over the volume is not put into box after box.
TEST(CellsLeftOut, RunsAllOverTheVolumeCountAnywhere)
{
    LeftOut leftOut({glm::dvec3(0), glm::dvec3(10)}, 1 << 22);
    leftOut.add(CellTree::Box{{0, 0, 0}, {10, 10, 10}}, 0.25);
    EXPECT_EQ(leftOut.leastIn({{3, 2, 2}, {3, 2, 2}}), 0.25);
    EXPECT_EQ(leftOut.least(), 0.25);
}

}  // namespace aeolic
