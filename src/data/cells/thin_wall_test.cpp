#include <gtest/gtest.h>

#include "data/cells/near_wall.h"
#include "data/cells/volume_testing.h"

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

}  // namespace
}  // namespace aeolic
