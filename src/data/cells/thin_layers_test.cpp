#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "data/cells/near_surface.h"
#include "data/cells/near_wall.h"
#include "data/cells/testing/volume_testing.h"

/// Walls of coarse facets, with cells beside them that are up to ten thousand times as wide as high. Heights and
/// distances count from the facets, however the normals on them lean.
namespace aeolic {
namespace {

using namespace testing_volumes;

constexpr int kFacets = 96, kLayers = 16;
constexpr double kTurn = 2 * std::numbers::pi / kFacets;
constexpr double kSlope = 50;  // Of the flow at the wall.

glm::dvec3 onCircle(double radius, double facet, double z)
{
    return {radius * std::cos(facet * kTurn), radius * std::sin(facet * kTurn), z};
}

/// How far off the cylinder's facets a point is.
double distanceToFacets(const glm::dvec3& p)
{
    const double middle = std::floor(std::atan2(p.y, p.x) / kTurn) + 0.5;
    return std::max({glm::dot(p, onCircle(1, middle, 0)), glm::dot(p, onCircle(1, middle - 1, 0)),
                     glm::dot(p, onCircle(1, middle + 1, 0))}) -
           std::cos(0.5 * kTurn);
}

/// At rest on the facets, around the cylinder beside them.
glm::dvec3 around(double x, double y, double z)
{
    const double distance = distanceToFacets({x, y, z}), speed = std::tanh(kSlope * distance);
    return distance < 1e-12 ? glm::dvec3(0) : speed * glm::normalize(glm::dvec3(-y, x, 0));
}

/// Brings the cells' values, each the mean of its corners', to the points: each has the mean of all cells that meet in
/// its place.
void takeMeansOfCells(VolumeCells& cells)
{
    std::map<std::tuple<double, double, double>, std::pair<glm::dvec3, int>> sums;
    const auto key = [&](std::uint32_t id) {
        return std::tuple(cells.points[id].x, cells.points[id].y, cells.points[id].z);
    };
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        std::vector<std::uint32_t> corners;
        cells.forEachFace(cell, [&](std::span<const std::uint32_t> face) {
            corners.insert(corners.end(), face.begin(), face.end());
        });
        glm::dvec3 sum(0);
        for (const std::uint32_t id : corners) sum += glm::dvec3(cells.vectors[id]) / double(corners.size());
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        for (const std::uint32_t id : corners) {
            sums[key(id)].first += sum;
            ++sums[key(id)].second;
        }
    }
    for (std::uint32_t id = 0; id < cells.points.size(); ++id)
        cells.vectors[id] = glm::vec3(sums[key(id)].first / double(sums[key(id)].second));
    cells.meansOfCells = true;
}

/// Around a cylinder of radius 1. The first cells have that height, the others grow. `inwards`: layers are numbered
/// from the outside. Its ends meet in points that it has twice, as two pieces do.
std::shared_ptr<VolumeCells> makeRing(double first, Shape shape, bool inwards)
{
    const auto place = [&](double x, double y, double z) {
        const double layer = std::round(kLayers * (inwards ? 1 - y : y));
        const double height = layer == 0 ? 0 : first * std::pow(1 / first, (layer - 1) / (kLayers - 1));
        return onCircle(1 + height, x == 1 ? 0 : std::round(kFacets * x), z);
    };
    return makeVolume({kFacets, kLayers, 3}, place, around, shape);
}

/// The facets' corners and the middles between them.
SurfaceMesh cylinder()
{
    SurfaceMesh mesh;
    for (int i = 0; i < kFacets; ++i)
        for (int k = 0; k <= 6; ++k) {
            const glm::dvec3 corner = onCircle(1, i, k / 6.0), next = onCircle(1, i + 1, k / 6.0);
            for (const glm::dvec3& p : {corner, 0.5 * (corner + next)}) {
                mesh.positions.emplace_back(p);
                mesh.normals.emplace_back(glm::normalize(glm::dvec3(p.x, p.y, 0)));
            }
        }
    return mesh;
}

class CurvedWall : public testing::TestWithParam<std::tuple<double, Shape>> {};

TEST_P(CurvedWall, TheShearIsTheSlopeWhereverValuesAre)
{
    const auto [first, shape] = GetParam();
    for (const bool inwards : {false, true})
        for (const bool ofCells : {false, true}) {
            const auto cells = makeRing(first, shape, inwards);
            if (ofCells) takeMeansOfCells(*cells);
            const CellSampler sampler(cells);
            WallLookup lookup;
            lookup.shear = lookup.shearLength = true;
            const WallValues values = lookUpNearWall(cylinder(), sampler, lookup);
            // The flow is bent within a first cell of 1e-2: tanh(0.5) is 0.92 of 0.5.
            const double least = (first > 5e-3 ? 0.8 : 0.95) * kSlope;
            for (const float shear : values.scalars) {
                EXPECT_GT(shear, least) << inwards << ofCells;
                EXPECT_LT(shear, 1.03 * kSlope) << inwards << ofCells;
            }
        }
}

TEST_P(CurvedWall, VectorsAreThoseOfHalfOfTheFirstCell)
{
    const auto [first, shape] = GetParam();
    const bool overBase = shape == Shape::tetra || shape == Shape::pyramid;  // Their tips are in half of that height.
    const double expected = std::tanh(kSlope * (overBase ? 0.25 : 0.5) * first);
    for (const bool inwards : {false, true}) {
        const CellSampler sampler(makeRing(first, shape, inwards));
        WallLookup lookup;
        lookup.length = true;
        const WallValues values = lookUpNearWall(cylinder(), sampler, lookup);
        // Coordinates of floats are up to 6e-8 off the wall.
        const double slack = 0.15 * expected + (overBase ? 1.05 * expected : 0) + kSlope * 1e-7;
        for (const float length : values.scalars) EXPECT_NEAR(length, expected, slack) << inwards;
    }
}

INSTANTIATE_TEST_SUITE_P(Layers, CurvedWall,
                         testing::Combine(testing::Values(1e-2, 1e-3, 1e-4, 1e-5, 1e-6),
                                          testing::Values(Shape::tetra, Shape::pyramid, Shape::wedge, Shape::hexahedron,
                                                          Shape::polyhedron)));

/// Two layers of cells over z = 0, of which the lower has heights from 0.03 to 0.09 that change from cell to cell.
std::shared_ptr<VolumeCells> unevenLayers(Shape shape)
{
    const auto place = [](double x, double y, double z) {
        const double low = 0.06 + 0.03 * std::sin(80 * x) * std::cos(70 * y);
        return glm::dvec3(x, y, z == 0 ? 0 : z < 0.75 ? low : 0.15);
    };
    const auto flow = [](double, double, double z) { return glm::dvec3(10 * z, -20 * z, 0); };
    return makeVolume({30, 30, 2}, place, flow, shape);
}

/// Points on z = `height` from `from` to `to`, with normals along z.
SurfaceMesh flatWall(double height, double from, double to, int n)
{
    SurfaceMesh mesh;
    mesh.originWorld = {0, 0, height};
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.positions.emplace_back(from + (to - from) * i / n, from + (to - from) * j / n, 0);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto a = std::uint32_t(j * (n + 1) + i), c = a + std::uint32_t(n + 1);
            mesh.triangles.push_back({a, a + 1, c});
            mesh.triangles.push_back({a + 1, c + 1, c});
        }
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    return mesh;
}

TEST(ThinLayers, UnevenCellsOfOneShearHaveThatShearEverywhere)
{
    for (const Shape shape : {Shape::tetra, Shape::pyramid, Shape::wedge, Shape::hexahedron, Shape::polyhedron}) {
        const auto cells = unevenLayers(shape);
        takeMeansOfCells(*cells);
        const CellSampler sampler(cells);
        WallLookup lookup;
        lookup.shear = true;
        for (const glm::vec3& v : lookUpNearWall(flatWall(0, 0, 1, 37), sampler, lookup).vectors)
            EXPECT_LT(glm::length(v - glm::vec3(10, -20, 0)), 0.02f) << int(shape);
    }
}

/// Not from other walls that are nearer to the cells' centres, as at the rim.
TEST(ThinLayers, TheShearIsThatOfTheWallAlsoWhereItsNormalsPointOutwards)
{
    const auto cells = unevenLayers(Shape::hexahedron);
    takeMeansOfCells(*cells);
    const CellSampler sampler(cells);
    SurfaceMesh wall = flatWall(0, 0, 1, 37);
    wall.normals.assign(wall.positions.size(), {0, 0, -1});
    WallLookup lookup;
    lookup.shear = true;
    for (const glm::vec3& v : lookUpNearWall(wall, sampler, lookup).vectors)
        EXPECT_LT(glm::length(v - glm::vec3(10, -20, 0)), 0.02f);
}

TEST(ThinLayers, APieceOfTheWallHasTheSameShearFromTheCellsAroundIt)
{
    const auto cells = unevenLayers(Shape::wedge);
    takeMeansOfCells(*cells);
    const CellSampler whole(cells);
    const SurfaceMesh piece = flatWall(0, 0.23, 0.41, 9);
    WallLookup lookup;
    lookup.shear = true;
    const auto shell = std::make_shared<VolumeCells>(
        shellOf(*cells, NearSurface(SurfaceZone(piece, lookUpReach(piece, whole, lookup)))));
    ASSERT_LT(shell->count(), cells->count() * 3 / 4);
    EXPECT_EQ(lookUpNearWall(piece, CellSampler(shell, whole.bounds()), lookup).vectors,
              lookUpNearWall(piece, whole, lookup).vectors);
}

/// Cells of 1/20, the first 1e-5 high. No slip at z = 0.
std::shared_ptr<VolumeCells> boundaryLayer()
{
    const auto place = [](double x, double y, double z) {
        const double layer = std::round(16 * z);
        return glm::dvec3(x, y, layer == 0 ? 0 : 1e-5 * std::pow(5e4, (layer - 1) / 15));
    };
    return makeVolume({20, 20, 16}, place,
                      [](double, double, double z) { return glm::dvec3(std::tanh(100 * z), 0, 0); });
}

TEST(ThinLayers, AWallBesideTheVolumeHasTheFlowOfItsFirstCells)
{
    const CellSampler sampler(boundaryLayer());
    for (const double up : {1.0, -1.0}) {
        SurfaceMesh wall = flatWall(-1e-3, 0, 1, 31);
        wall.normals.assign(wall.positions.size(), {0, 0, up});
        EXPECT_EQ(pointsTowardsVolume(wall, sampler), std::int64_t(up) * std::int64_t(wall.positions.size()));
        WallLookup lookup;
        lookup.side = up;
        const WallValues values = lookUpNearWall(wall, sampler, lookup);
        EXPECT_EQ(values.inside, std::int64_t(wall.positions.size()));
        for (const glm::vec3& v : values.vectors) EXPECT_NEAR(v.x, 5e-4, 1e-5);
        for (const double reach : lookUpReach(wall, sampler, lookup)) EXPECT_GT(reach, 1e-3);
        lookup.shear = true;
        for (const glm::vec3& v : lookUpNearWall(wall, sampler, lookup).vectors) EXPECT_NEAR(v.x, 100, 1);
    }
}

TEST(ThinLayers, WhereAWallLeavesTheVolumeItHasTheFlowAtTheRim)
{
    const CellSampler sampler(boundaryLayer());
    const SurfaceMesh wall = flatWall(0, -0.02, 1.02, 52);  // Cells count for 0.035 around them.
    const WallValues values = lookUpNearWall(wall, sampler, {});
    EXPECT_EQ(values.inside, std::int64_t(wall.positions.size()));
    for (const glm::vec3& v : values.vectors) EXPECT_NEAR(v.x, 5e-4, 1e-5);
}

}  // namespace
}  // namespace aeolic
