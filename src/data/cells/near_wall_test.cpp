#include "data/cells/near_wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "data/cells/refine.h"
#include "data/cells/testing/volume_testing.h"

namespace aeolic {
namespace {

using namespace testing_volumes;

constexpr double kDegrees = 180 / std::numbers::pi;

/// Cells that are thin beside y = 0.
glm::dvec3 stretched(double x, double y, double z)
{
    return {x, 1e-3 * (std::exp(y * std::log(1001.0)) - 1), z};
}

/// No slip at y = 0. Away from the wall the flow turns, faster where x is large.
glm::dvec3 boundaryLayer(double x, double y, double)
{
    const double angle = 0.4 * std::sin(3 * x) + 2 * y, speed = 1 - std::exp(-20 * y);
    return {speed * std::cos(angle), 0, speed * std::sin(angle)};
}

double directionAtWall(double x)
{
    return 0.4 * std::sin(3 * x);
}

/// Points across the plane y = `height`, with normals `up`.
SurfaceMesh plate(double height, const glm::vec3& up, int n = 20)
{
    SurfaceMesh mesh;
    mesh.originWorld = {0.5, height, 0.5};
    for (int z = 0; z <= n; ++z)
        for (int x = 0; x <= n; ++x) mesh.positions.emplace_back(x / float(n) - 0.5f, 0, z / float(n) - 0.5f);
    for (std::uint32_t z = 0; z < std::uint32_t(n); ++z)
        for (std::uint32_t x = 0; x < std::uint32_t(n); ++x) {
            const std::uint32_t a = z * std::uint32_t(n + 1) + x, c = a + std::uint32_t(n + 1);
            mesh.triangles.push_back({a, c, a + 1});
            mesh.triangles.push_back({a + 1, c, c + 1});
        }
    mesh.normals.assign(mesh.positions.size(), up);
    return mesh;
}

const glm::vec3 kUp{0, 1, 0};

/// Degrees between the vectors found and the flow's direction at the wall, in rising order.
std::vector<double> errorsAtWall(const SurfaceMesh& mesh, const WallValues& values)
{
    std::vector<double> errors;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double x = mesh.originWorld.x + double(mesh.positions[i].x);
        const double found = std::atan2(double(values.vectors[i].z), double(values.vectors[i].x));
        const bool flows = glm::length(values.vectors[i]) > 0;
        errors.push_back(flows ? std::abs(std::remainder(found - directionAtWall(x), 2 * std::numbers::pi)) * kDegrees
                               : 180);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

void expectDirections(const SurfaceMesh& mesh, const WallValues& values)
{
    const std::vector<double> errors = errorsAtWall(mesh, values);
    EXPECT_LE(errors[errors.size() / 2], 1);
    EXPECT_LE(errors[errors.size() * 99 / 100], 5);
}

class NearWall : public testing::TestWithParam<Shape> {};

TEST_P(NearWall, DirectionsAtAWallWithoutSlip)
{
    const CellSampler sampler(makeVolume({20, 24, 6}, stretched, boundaryLayer, GetParam()));
    const SurfaceMesh wall = plate(0, kUp);
    const WallValues values = lookUpNearWall(wall, sampler, {});
    EXPECT_EQ(values.inside, std::int64_t(wall.positions.size()));
    expectDirections(wall, values);
}

INSTANTIATE_TEST_SUITE_P(Shapes, NearWall,
                         testing::Values(Shape::tetra, Shape::pyramid, Shape::wedge, Shape::hexahedron,
                                         Shape::polyhedron));

TEST(NearWallCases, NormalsThatPointTheWrongWay)
{
    const CellSampler sampler(makeVolume({20, 24, 6}, stretched, boundaryLayer));
    const SurfaceMesh wall = plate(0, -kUp);
    expectDirections(wall, lookUpNearWall(wall, sampler, {}));
}

TEST(NearWallCases, APlateWithinAVolumeHasEachSidesFlow)
{
    const auto flow = [](double, double y, double) { return y > 0 ? glm::dvec3(y, 0, 0) : glm::dvec3(0, 0, -y); };
    const auto place = [](double x, double y, double z) { return glm::dvec3(x, 2 * y - 1, z); };
    const CellSampler sampler(makeVolume({4, 8, 4}, place, flow));
    const WallValues above = lookUpNearWall(plate(0, kUp, 4), sampler, {}),
                     below = lookUpNearWall(plate(0, -kUp, 4), sampler, {});
    for (const glm::vec3& v : above.vectors) {
        EXPECT_GT(v.x, 0);
        EXPECT_EQ(v.z, 0);
    }
    for (const glm::vec3& v : below.vectors) {
        EXPECT_EQ(v.x, 0);
        EXPECT_GT(v.z, 0);
    }
}

TEST(NearWallCases, WhereThereIsFlowOnTheSurfaceItIsTakenThere)
{
    const auto cells = makeVolume({4, 4, 4}, unitBox, linearFlow);
    const CellSampler sampler(cells);
    WallLookup lookup;
    lookup.scalar = true;
    const SurfaceMesh surface = plate(0.4, kUp, 7);
    const WallValues values = lookUpNearWall(surface, sampler, lookup);
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        const glm::dvec3 p = surface.originWorld + glm::dvec3(surface.positions[i]);
        EXPECT_LT(glm::length(glm::dvec3(values.vectors[i]) - linearFlow(p.x, p.y, p.z)), 1e-5);
        EXPECT_NEAR(values.scalars[i], p.x + 2 * p.y - p.z, 1e-5);
    }
}

TEST(NearWallCases, AnOffsetIsALengthAlongTheNormal)
{
    const CellSampler sampler(makeVolume({4, 4, 4}, unitBox, linearFlow));
    const SurfaceMesh surface = plate(0.4, kUp, 5);
    WallLookup lookup;
    for (const double offset : {0.0, 0.3, -0.2}) {
        lookup.offsetWorld = offset;
        const WallValues values = lookUpNearWall(surface, sampler, lookup);
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            const glm::dvec3 p = surface.originWorld + glm::dvec3(surface.positions[i]);
            EXPECT_LT(glm::length(glm::dvec3(values.vectors[i]) - linearFlow(p.x, 0.4 + offset, p.z)), 1e-5);
        }
    }
    for (const double huge : {1e30, -1e30}) {
        lookup.offsetWorld = huge;
        const WallValues values = lookUpNearWall(surface, sampler, lookup);
        EXPECT_EQ(values.inside, 0);
        for (const glm::vec3& v : values.vectors) EXPECT_TRUE(std::isnan(v.x));
    }
}

TEST(NearWallCases, AFieldThatDoesNotTouchTheSurface)
{
    const CellSampler sampler(makeVolume({2, 2, 2}, unitBox, linearFlow));
    const WallValues values = lookUpNearWall(plate(9, kUp, 3), sampler, {});
    EXPECT_EQ(values.inside, 0);
    for (const glm::vec3& v : values.vectors) EXPECT_TRUE(std::isnan(v.x));
}

TEST(NearWallCases, ASurfaceInsideASolidHole)
{
    auto cells = makeVolume({9, 9, 9}, unitBox, linearFlow);  // Without the cells around the middle.
    VolumeCells around = *cells;
    around.shapes.clear();
    around.first.assign(1, 0);
    around.corners.clear();
    for (std::uint32_t cell = 0; cell < cells->count(); ++cell) {
        const auto within = [](std::uint32_t i) { return i >= 2 && i < 7; };
        if (within(cell % 9) && within(cell / 9 % 9) && within(cell / 81)) continue;
        around.shapes.push_back(cells->shapes[cell]);
        for (std::uint64_t k = cells->first[cell]; k < cells->first[cell + 1]; ++k)
            around.corners.push_back(cells->corners[k]);
        around.first.push_back(around.corners.size());
    }
    const CellSampler sampler(std::make_shared<const VolumeCells>(around));
    const SurfaceMesh surface = plate(0.5, kUp, 40);
    const WallValues values = lookUpNearWall(surface, sampler, {});
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        const glm::vec3 p = glm::abs(surface.positions[i]);
        const float toEdge = 2.5f / 9 - std::max(p.x, p.z);  // Half a cell's diagonal is 0.096.
        if (toEdge > 0.09f && toEdge < 0.1f) continue;
        EXPECT_EQ(std::isnan(values.vectors[i].x), toEdge > 0.1f) << i;
    }
}

TEST(NearWallCases, MasksThatReachBeyondAFewCellsStay)
{
    const auto cells = makeVolume({10, 40, 10}, unitBox, boundaryLayer);
    for (std::size_t i = 0; i < cells->points.size(); ++i) {
        const glm::dvec3& p = cells->points[i];
        if (p.y < 0.06 || p.x < 0.45) cells->vectors[i] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    }
    const CellSampler sampler(cells);
    const SurfaceMesh wall = plate(0, kUp, 20);
    const WallValues values = lookUpNearWall(wall, sampler, {});
    EXPECT_EQ(values.inside, std::int64_t(wall.positions.size()));
    for (std::size_t i = 0; i < wall.positions.size(); ++i) {
        const double x = wall.originWorld.x + double(wall.positions[i].x);
        if (x > 0.46 && x < 0.54) continue;  // Beside the mask's border.
        EXPECT_EQ(std::isnan(values.vectors[i].x), x < 0.5) << x;
        if (x < 0.5) continue;
        const double found = std::atan2(double(values.vectors[i].z), double(values.vectors[i].x));
        EXPECT_LT(std::abs(found - directionAtWall(x)), 0.3) << "three layers off the wall";
    }
}

TEST(NearWallCases, WhereNothingFlowsTheVectorIsZero)
{
    const CellSampler still(makeVolume({3, 3, 3}, unitBox, [](double, double, double) { return glm::dvec3(0); }));
    for (const glm::vec3& v : lookUpNearWall(plate(0, kUp, 3), still, {}).vectors) EXPECT_EQ(v, glm::vec3(0));
}

TEST(NearWallCases, ShearIsTheChangeWithTheDistance)
{
    const auto flow = [](double, double y, double) { return glm::dvec3(3 * y, 0, -1.5 * y); };
    const CellSampler sampler(makeVolume({6, 5, 6}, unitBox, flow));
    WallLookup lookup;
    lookup.shear = true;
    for (const glm::vec3& normal : {kUp, -kUp}) {
        const SurfaceMesh wall = plate(0, normal, 8);
        const WallValues values = lookUpNearWall(wall, sampler, lookup);
        for (std::size_t i = 0; i < wall.positions.size(); ++i)
            EXPECT_LT(glm::length(values.vectors[i] - glm::vec3(3, 0, -1.5f)), 1e-4f) << i;
    }
}

TEST(NearWallCases, ACoarseSurfaceIsCutAsFineAsTheCells)
{
    const CellSampler sampler(makeVolume({20, 24, 20}, stretched, boundaryLayer));
    SurfaceMesh wall = plate(0, kUp, 1);
    const auto tooLong = [&](const glm::dvec3& a, const glm::dvec3& b) { return longerThanCell(sampler, a, b); };
    while (true) {
        const EdgeCuts cuts = findCuts(wall, tooLong);
        if (cuts.ends.empty()) break;
        cutEdges(wall, cuts);
        ASSERT_EQ(wall.triangles.size(), cuts.triangles);
        ASSERT_LT(wall.triangles.size(), 100000u);
    }
    EXPECT_GT(wall.triangles.size(), 400u);
    expectDirections(wall, lookUpNearWall(wall, sampler, {}));
}

TEST(NearWallCases, AHugeSurfaceIsCutOnlyAroundTheVolume)
{
    const CellSampler sampler(makeVolume({10, 10, 10}, unitBox, linearFlow));
    SurfaceMesh huge = plate(0.5, kUp, 1);
    for (glm::vec3& p : huge.positions) p *= 200.0f;
    const auto tooLong = [&](const glm::dvec3& a, const glm::dvec3& b) { return longerThanCell(sampler, a, b); };
    for (int round = 0; round < kMostRefinements; ++round) {
        const EdgeCuts cuts = findCuts(huge, tooLong);
        if (cuts.ends.empty()) break;
        cutEdges(huge, cuts);
    }
    EXPECT_LT(huge.triangles.size(), 20000u);
    EXPECT_GT(lookUpNearWall(huge, sampler, {}).inside, 80);
}

TEST(NearWallCases, CellsThatAreThinnerThanFarAwayCutNothing)
{
    // Long cells, which a plate at 30 is near enough to for their values, but too far away for their width.
    const auto needle = [](double x, double y, double z) { return glm::dvec3(1000 * x, 1e-3 * y, 1e-3 * z); };
    const CellSampler sampler(makeVolume({10, 4, 4}, needle, linearFlow));
    const glm::dvec3 beside(450, 0, 30), along(20, 0, 0), across(0, 20, 0);
    const auto isCut = [&](const glm::dvec3& middle, const glm::dvec3& half) {
        return longerThanCell(sampler, middle - half, middle + half);
    };
    EXPECT_FALSE(isCut(beside, across));
    EXPECT_FALSE(isCut(beside, along));
    EXPECT_TRUE(isCut(beside, 2.0 * across));
    EXPECT_TRUE(isCut({450, 0, 0}, 1e-3 * across));
}

TEST(NearWallLong, DirectionsInAMillionCells)
{
    const CellSampler sampler(makeVolume({100, 100, 100}, stretched, boundaryLayer));
    const SurfaceMesh wall = plate(0, kUp, 300);
    const WallValues values = lookUpNearWall(wall, sampler, {});
    expectDirections(wall, values);
    const std::vector<double> errors = errorsAtWall(wall, values);
    EXPECT_LE(errors[errors.size() / 2], 0.1);
    EXPECT_LE(errors.back(), 1);
}

}  // namespace
}  // namespace aeolic
