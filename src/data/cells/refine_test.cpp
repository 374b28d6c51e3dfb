#include "data/cells/refine.h"

#include <gtest/gtest.h>
#include "data/cells/grid_sampler.h"
#include "data/cells/near_wall.h"

#include <map>
#include <set>
#include <tuple>

namespace aeolic {
namespace {

/// A fan of triangles around the origin, with values of all kinds.
SurfaceMesh fan()
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -3, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    mesh.normals.assign(5, glm::vec3(0, 0, 1));
    mesh.pointScalars = {0, 1, 2, 3, 4};
    mesh.cellScalars = {10, 11, 12, 13};
    mesh.order = {5, 6, 7, 8};
    return mesh;
}

double areaOf(const SurfaceMesh& mesh)
{
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += 0.5 * double(glm::length(
                          glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])));
    return area;
}

using Corner = std::tuple<float, float, float>;

std::set<std::set<Corner>> trianglesOf(const SurfaceMesh& mesh)
{
    std::set<std::set<Corner>> all;
    for (const auto& triangle : mesh.triangles) {
        std::set<Corner> corners;
        for (const std::uint32_t id : triangle) {
            const glm::vec3& p = mesh.positions[id];
            corners.insert({p.x, p.y, p.z});
        }
        all.insert(corners);
    }
    return all;
}

void refineAll(SurfaceMesh& mesh, double longest)
{
    for (int round = 0; round < kMostRefinements; ++round)
        cutEdges(mesh, findCuts(mesh, [&](const glm::dvec3& a, const glm::dvec3& b) {
                     return glm::length(a - b) > longest;
                 }));
}

/// A fold: between opposite normals there is no mean, and the end with the lower number counts, from either triangle.
TEST(Refine, BetweenOppositeNormalsThatOfTheFirstEndIsTaken)
{
    SurfaceMesh mesh = fan();
    mesh.normals = {{0, 0, 1}, {0, 0, -1}, {0, 0, -1}, {0, 0, 1}, {0, 0, -1}};
    const std::vector<glm::vec3> before = mesh.normals;
    const EdgeCuts cuts = findCuts(mesh, [](const glm::dvec3&, const glm::dvec3&) { return true; });
    cutEdges(mesh, cuts);
    ASSERT_EQ(cuts.ends.size(), 8u);
    for (std::size_t i = 0; i < cuts.ends.size(); ++i) {
        const glm::uvec2& end = cuts.ends[i];
        EXPECT_EQ(mesh.normals[5 + i], before[std::min(end.x, end.y)]) << end.x << " " << end.y;
    }
}

TEST(Refine, EveryNumberOfCutEdgesKeepsTheSurface)
{
    for (const double longest : {3.5, 2.5, 1.9, 1.2, 0.7, 0.3}) {
        SurfaceMesh mesh = fan();
        refineAll(mesh, longest);
        EXPECT_NEAR(areaOf(mesh), areaOf(fan()), 1e-5) << longest;
        EXPECT_EQ(mesh.cellScalars.size(), mesh.triangles.size());
        EXPECT_EQ(mesh.order.size(), mesh.triangles.size());
        EXPECT_EQ(mesh.pointScalars.size(), mesh.positions.size());
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const auto& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_LE(glm::length(mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]), float(longest));
                ++edges[{t[k], t[(k + 1) % 3]}];
            }
        for (const auto& [edge, count] : edges) EXPECT_EQ(count, 1) << "turned or torn at " << edge.first;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            EXPECT_EQ(mesh.order[i] + 5, std::uint64_t(mesh.cellScalars[i]));
    }
}

TEST(Refine, PiecesAreCutAsTheWholeIs)
{
    SurfaceMesh whole = fan();
    refineAll(whole, 0.4);
    std::set<std::set<Corner>> ofPieces;
    for (std::size_t i = 0; i < 4; ++i) {
        SurfaceMesh piece = fan();
        const auto triangle = piece.triangles[i];
        piece.triangles = {{triangle[2], triangle[0], triangle[1]}};  // In another order of points, too.
        piece.cellScalars = {0};
        piece.order = {0};
        refineAll(piece, 0.4);
        ofPieces.merge(trianglesOf(piece));
    }
    EXPECT_EQ(ofPieces, trianglesOf(whole));
}

/// Damaged files have such cells. Without a limit each round of refinement would cut every edge.
TEST(Refine, CellsWithoutWidthCutNoEdge)
{
    GridField grid;
    grid.dims = {5, 4, 3};
    grid.originWorld = {-1e61, -1, -1};
    grid.spacingWorld = {1e61, 1e-310, 1};
    grid.samples = std::make_shared<std::vector<float>>(180, 1.0f);
    const GridSampler sampler(std::make_shared<const GridField>(grid), nullptr);
    EXPECT_FALSE(longerThanCell(sampler, {0, -1.5, 0}, {0, -0.5, 0}));
    grid.originWorld = {-1, -1, -1};
    grid.spacingWorld = {1, 1e-5, 1};
    const GridSampler thin(std::make_shared<const GridField>(grid), nullptr);
    EXPECT_TRUE(longerThanCell(thin, {0, -1.5, 0}, {0, -0.5, 0})) << "as in a boundary layer";
}

}  // namespace
}  // namespace aeolic
