#include <gtest/gtest.h>

#include <cmath>

#include "data/cells/near_wall.h"
#include "data/cells/testing/volume_testing.h"

/// A sheet at y = 0 within a volume whose cells are fine on one side and coarse on the other.
namespace aeolic {
namespace {

using namespace testing_volumes;

constexpr double kFine = 0.05, kCoarse = 0.5;
const glm::vec3 kUp{0, 1, 0};

/// Two layers of fine cells above the sheet, two of coarse ones below.
glm::dvec3 fineAbove(double x, double y, double z)
{
    const double layer = 4 * y - 2;
    return {x, layer * (layer > 0 ? kFine : kCoarse), z};
}

/// At rest on the sheet. Along x above it, along z below.
glm::dvec3 flowOfEitherSide(double, double y, double)
{
    return y > 0 ? glm::dvec3(y, 0, 0) : glm::dvec3(0, 0, -y);
}

/// Inner points of the sheet: there are cells all around.
SurfaceMesh sheet(const glm::vec3& normal)
{
    SurfaceMesh mesh;
    for (const float x : {0.3f, 0.45f, 0.7f})
        for (const float z : {0.35f, 0.6f}) mesh.positions.emplace_back(x, 0, z);
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
    mesh.normals.assign(mesh.positions.size(), normal);
    return mesh;
}

/// Notes how far off the sheet something is asked for.
class WatchedSampler final : public VolumeSampler {
public:
    explicit WatchedSampler(std::shared_ptr<const VolumeCells> cells) : cells_(std::move(cells)) {}

    mutable double farthest = 0;

    bool findWithin(const glm::dvec3& p, CellPlace& place) const override { return cells_.findWithin(noted(p), place); }
    bool find(const glm::dvec3& p, const glm::dvec3& towards, CellPlace& place) const override
    {
        return cells_.find(noted(p), towards, place);
    }
    glm::dvec3 vectorAt(const CellPlace& place) const override { return cells_.vectorAt(place); }
    double scalarAt(const CellPlace& place) const override { return cells_.scalarAt(place); }
    glm::dvec3 pointOf(const CellPlace& place) const override { return cells_.pointOf(place); }
    double heightOver(const CellPlace& place, const glm::dvec3& p, const glm::dvec3& normal) const override
    {
        return cells_.heightOver(place, p, normal);
    }
    double meanDistanceOfCenters(const glm::dvec3& p, const glm::dvec3& towards) const override
    {
        return cells_.meanDistanceOfCenters(p, towards);
    }
    double reachOfCenters(const glm::dvec3& p, const glm::dvec3& towards) const override
    {
        return cells_.reachOfCenters(p, towards);
    }
    double widthOf(const CellPlace& place, const glm::dvec3& d) const override { return cells_.widthOf(place, d); }
    const Bounds& bounds() const override { return cells_.bounds(); }
    double maxVector() const override { return cells_.maxVector(); }

private:
    const glm::dvec3& noted(const glm::dvec3& p) const
    {
        farthest = std::max(farthest, std::abs(p.y));
        return p;
    }

    CellSampler cells_;
};

/// Half as far off as the cell on the side looked at reaches: half of that cell's vectors there.
TEST(NearWallSides, EachSideHasTheFlowInTheMiddleOfItsOwnCell)
{
    const CellSampler sampler(makeVolume({5, 4, 5}, fineAbove, flowOfEitherSide));
    for (const float up : {1.0f, -1.0f})
        for (const double side : {1.0, -1.0}) {
            WallLookup lookup;
            lookup.side = side;
            const bool isAbove = side * double(up) > 0;
            const glm::vec3 expected = isAbove ? glm::vec3(0.5 * kFine, 0, 0) : glm::vec3(0, 0, 0.5 * kCoarse);
            for (const glm::vec3& v : lookUpNearWall(sheet(up * kUp), sampler, lookup).vectors)
                EXPECT_LT(glm::length(v - expected), 1e-5f) << up << ' ' << side;
        }
}

/// Where nothing flows on the side looked at the flow of the other is taken, as far off as this side's cell says.
TEST(NearWallSides, WhereNothingFlowsOnOneSideTheOtherIsTaken)
{
    const auto still = [](bool above) {
        return makeVolume({5, 4, 5}, fineAbove, [above](double x, double y, double z) {
            return (y > 0) == above ? glm::dvec3(0) : flowOfEitherSide(x, y, z);
        });
    };
    WallLookup lookup;
    for (const glm::vec3& v : lookUpNearWall(sheet(kUp), CellSampler(still(true)), lookup).vectors)
        EXPECT_LT(glm::length(v - glm::vec3(0, 0, 0.5 * kFine)), 1e-5f);
    lookup.side = -1;  // The middle of the coarse cell is as far as all of the fine ones.
    const WallValues beyond = lookUpNearWall(sheet(kUp), CellSampler(still(false)), lookup);
    for (std::size_t i = 0; i < beyond.vectors.size(); ++i) {
        EXPECT_EQ(beyond.vectors[i], glm::vec3(0));
        EXPECT_TRUE(beyond.atRest[i]);
    }
}

TEST(NearWallSides, AnOffsetIsToTheSideLookedAt)
{
    const CellSampler sampler(makeVolume({5, 4, 5}, fineAbove, flowOfEitherSide));
    WallLookup lookup;
    lookup.offsetWorld = 0.04;
    for (const double side : {1.0, -1.0}) {
        lookup.side = side;
        const glm::vec3 expected = side > 0 ? glm::vec3(0.04, 0, 0) : glm::vec3(0, 0, 0.04);
        for (const glm::vec3& v : lookUpNearWall(sheet(kUp), sampler, lookup).vectors)
            EXPECT_LT(glm::length(v - expected), 1e-5f) << side;
    }
}

TEST(NearWallSides, ShearOfEachSide)
{
    const CellSampler sampler(makeVolume({5, 4, 5}, fineAbove, flowOfEitherSide));
    WallLookup lookup;
    lookup.shear = true;
    for (const double side : {1.0, -1.0}) {
        lookup.side = side;
        const glm::vec3 expected = side > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
        for (const glm::vec3& v : lookUpNearWall(sheet(kUp), sampler, lookup).vectors)
            EXPECT_LT(glm::length(v - expected), 1e-4f) << side;
    }
}

/// A surface that does not know yet which side it looks at needs the cells of the coarser one.
TEST(NearWallSides, TheReachIsThatOfTheCoarserSide)
{
    const auto cells = makeVolume({5, 8, 5}, fineAbove, [](double, double, double) { return glm::dvec3(0); });
    const double layer = 0.5 * kCoarse;  // Eight layers: each is half as thick.
    for (const float up : {1.0f, -1.0f}) {
        const SurfaceMesh mesh = sheet(up * kUp);
        for (const int tries : {1, 2, 3, 4}) {
            WallLookup lookup;
            lookup.tries = tries;
            const WatchedSampler sampler(cells);
            const std::vector<double> reach = lookUpReach(mesh, sampler, lookup);
            sampler.farthest = 0;
            for (const double side : {1.0, -1.0}) {
                lookup.side = side;
                lookUpNearWall(mesh, sampler, lookup);
            }
            pointsTowardsVolume(mesh, sampler);
            EXPECT_NEAR(sampler.farthest, 0.5 * layer * (1 << (tries - 1)), 1e-6);
            for (const double each : reach) {
                EXPECT_GE(each, sampler.farthest) << tries;
                EXPECT_LE(each, sampler.farthest * 1.001) << tries;
            }
        }
    }
}

/// Flow beside a surface is looked for as far off as the cell reaches that the normal points to.
TEST(NearWallSides, FlowOnBothSidesSaysNothingOfTheVolumesSide)
{
    const CellSampler both(makeVolume({5, 4, 5}, fineAbove, flowOfEitherSide));
    EXPECT_EQ(pointsTowardsVolume(sheet(kUp), both), 0);
    const CellSampler above(makeVolume(
        {5, 4, 5}, [](double x, double y, double z) { return glm::dvec3(x, y, z); }, linearFlow));
    EXPECT_EQ(pointsTowardsVolume(sheet(kUp), above), 6);
    EXPECT_EQ(pointsTowardsVolume(sheet(-kUp), above), -6);
}

}  // namespace
}  // namespace aeolic
