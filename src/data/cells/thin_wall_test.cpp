#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/cells/near_wall.h"
#include "data/cells/testing/volume_testing.h"

/// A wall without thickness between two volumes that share no point: each of its sides has its own cells.
namespace aeolic {
namespace {

using namespace testing_volumes;

constexpr double kHeight = 1.0 / 3;  // Not a float: points of the wall are a little above or below it.

void append(VolumeCells& all, const VolumeCells& more)
{
    const auto shift = std::uint32_t(all.points.size());
    all.points.insert(all.points.end(), more.points.begin(), more.points.end());
    all.vectors.insert(all.vectors.end(), more.vectors.begin(), more.vectors.end());
    all.scalars.insert(all.scalars.end(), more.scalars.begin(), more.scalars.end());
    for (std::size_t cell = 0; cell < more.count(); ++cell) {
        all.shapes.push_back(more.shapes[cell]);
        for (std::uint64_t k = more.first[cell]; k < more.first[cell + 1]; ++k)
            all.corners.push_back(more.corners[k] + shift);
        all.first.push_back(all.corners.size());
    }
    all.maxVector = std::max(all.maxVector, more.maxVector);
}

/// Above the wall the flow is along x, below along z. `slip`: also on the wall.
CellSampler twoVolumes(double slip)
{
    const auto place = [](double from) {
        return [from](double x, double y, double z) { return glm::dvec3(x, kHeight + from + 0.5 * y, z); };
    };
    auto cells =
        makeVolume({6, 3, 6}, place(0), [&](double, double y, double) { return glm::dvec3(slip + y - kHeight, 0, 0); });
    append(*cells, *makeVolume({6, 3, 6}, place(-0.5),
                               [&](double, double y, double) { return glm::dvec3(0, 0, slip + kHeight - y); }));
    return CellSampler(cells);
}

SurfaceMesh wallAt(double height, float up)
{
    SurfaceMesh mesh;
    mesh.originWorld = {0.7, 0, 0.1};
    for (int k = 0; k <= 8; ++k)
        for (int i = 0; i <= 8; ++i)
            mesh.positions.emplace_back(float(i) / 9 - 0.7f, float(height), float(k) / 9 - 0.1f);
    mesh.normals.assign(mesh.positions.size(), {0, up, 0});
    return mesh;
}

TEST(ThinWall, EachSideHasItsOwnFlow)
{
    for (const double slip : {0.0, 1.0}) {
        const CellSampler sampler = twoVolumes(slip);
        for (const float up : {1.0f, -1.0f})
            for (const double side : {1.0, -1.0}) {
                WallLookup lookup;
                lookup.side = side;
                const WallValues values = lookUpNearWall(wallAt(kHeight, up), sampler, lookup);
                for (const glm::vec3& v : values.vectors) {
                    EXPECT_GT(up * side > 0 ? v.x : v.z, 0) << slip << " " << up << " " << side;
                    EXPECT_EQ(up * side > 0 ? v.z : v.x, 0) << slip << " " << up << " " << side;
                }
            }
    }
}

TEST(ThinWall, ItSaysNothingOfWhereNormalsPoint)
{
    const CellSampler sampler = twoVolumes(0);
    const auto points = std::int64_t(wallAt(0, 1).positions.size());
    EXPECT_EQ(pointsTowardsVolume(wallAt(kHeight, 1), sampler), 0);
    EXPECT_EQ(pointsTowardsVolume(wallAt(kHeight - 0.5, 1), sampler), points);
    EXPECT_EQ(pointsTowardsVolume(wallAt(kHeight - 0.5, -1), sampler), -points);
    EXPECT_EQ(pointsTowardsVolume(wallAt(kHeight + 0.5, 1), sampler), -points);
    EXPECT_EQ(pointsTowardsVolume(wallAt(9, 1), sampler), 0);
}

/// One layer of cells on each side of y = 0: small and thin ones above, large and thick ones below, which reach a
/// little farther and share no corner with the others. Each side has one vector, as cells' values brought to points
/// have it.
constexpr int kFine = 11, kCoarse = 2;  // Cells in a row.
constexpr double kThin = 0.02, kThick = 0.5, kMore = 0.03, kWide = (1 + 2 * kMore) / kCoarse;

CellSampler unequalLayers()
{
    const auto cells = makeVolume(
        {kFine, 1, kFine}, [](double x, double y, double z) { return glm::dvec3(x, kThin * y, z); },
        [](double, double, double) { return glm::dvec3(0.5 * kThin, 0, 0); });
    const auto below = [](double x, double y, double z) {
        return glm::dvec3(kCoarse * kWide * x - kMore, -kThick * y, kCoarse * kWide * z - kMore);
    };
    append(*cells, *makeVolume({kCoarse, 1, kCoarse}, below,
                               [](double, double, double) { return glm::dvec3(0, 0, 0.5 * kThick); }));
    cells->meansOfCells = true;
    return CellSampler(cells);
}

/// Each side's vector over the distance of its own cells' centres.
TEST(ThinWall, EachSideHasTheShearOfItsOwnCells)
{
    const CellSampler sampler = unequalLayers();
    for (const float up : {1.0f, -1.0f})
        for (const double side : {1.0, -1.0}) {
            WallLookup lookup;
            lookup.shear = true;
            lookup.side = side;
            const glm::vec3 expected = up * side > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
            for (const glm::vec3& v : lookUpNearWall(wallAt(0, up), sampler, lookup).vectors)
                EXPECT_LT(glm::length(v - expected), 1e-4f) << up << " " << side;
        }
}

/// A surface that does not know yet which side it looks at needs all cells around the corners of the larger faces.
TEST(ThinWall, TheReachIsThatOfTheSideWithTheLargerFaces)
{
    const CellSampler sampler = unequalLayers();
    WallLookup lookup;
    lookup.shear = true;
    lookup.tries = 1;
    for (const float up : {1.0f, -1.0f}) {
        const SurfaceMesh wall = wallAt(0, up);
        const std::vector<double> reach = lookUpReach(wall, sampler, lookup);
        for (std::size_t i = 0; i < reach.size(); ++i) {
            const glm::dvec3 point = wall.originWorld + glm::dvec3(wall.positions[i]);
            const auto toCorner = [](double at) {
                const double begin = std::floor((at + kMore) / kWide) * kWide - kMore;
                return std::max(at - begin, begin + kWide - at);
            };
            const double corner = std::hypot(toCorner(point.x), toCorner(point.z));
            EXPECT_NEAR(reach[i], corner, 1e-6) << up << " at " << point.x << " " << point.z;
        }
    }
}

}  // namespace
}  // namespace aeolic
