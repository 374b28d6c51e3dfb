#include "data/cells/cell_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "data/cells/testing/volume_testing.h"

namespace aeolic {
namespace {

using namespace testing_volumes;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

glm::dvec3 bent(double x, double y, double z)
{
    return {x + 0.1 * y * z, y * y + 0.2 * y + 0.05 * x, z + 0.1 * std::sin(3 * x)};
}

class EveryShape : public testing::TestWithParam<Shape> {};

TEST_P(EveryShape, ALinearFieldIsExactInBentCells)
{
    const CellSampler sampler(makeVolume({5, 6, 4}, bent, linearFlow, GetParam()));
    int inside = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p =
            bent(0.1 + 0.8 * std::fmod(i * 0.7548776662, 1), 0.1 + 0.8 * std::fmod(i * 0.5698402910, 1),
                 0.1 + 0.8 * std::fmod(i * 0.3247179572, 1));
        CellPlace place;
        if (!sampler.findWithin(p, place)) continue;
        ++inside;
        EXPECT_LT(glm::length(sampler.vectorAt(place) - linearFlow(p.x, p.y, p.z)), 1e-6) << i;
        EXPECT_NEAR(sampler.scalarAt(place), p.x + 2 * p.y - p.z, 1e-6) << i;
    }
    EXPECT_EQ(inside, 1000);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape,
                         testing::Values(Shape::tetra, Shape::pyramid, Shape::wedge, Shape::hexahedron,
                                         Shape::polyhedron));

TEST(CellSampler, OneCellIsAVolume)
{
    const CellSampler sampler(makeVolume({1, 1, 1}, unitBox, linearFlow));
    CellPlace place;
    ASSERT_TRUE(sampler.findWithin({0.3, 0.6, 0.9}, place));
    EXPECT_LT(glm::length(sampler.vectorAt(place) - linearFlow(0.3, 0.6, 0.9)), 1e-6);
    EXPECT_FALSE(sampler.findWithin({0.3, 0.6, 1.1}, place));
}

TEST(CellSampler, OutsideTheNearestCellCountsForHalfOfItsDiagonal)
{
    const CellSampler sampler(makeVolume({2, 2, 2}, unitBox, linearFlow));
    const double half = 0.5 * std::sqrt(3 * 0.25);
    CellPlace place;
    ASSERT_TRUE(sampler.find({0.3, 0.4, 1 + 0.99 * half}, glm::dvec3(0), place));
    EXPECT_LT(glm::length(sampler.vectorAt(place) - linearFlow(0.3, 0.4, 1)), 1e-6);
    EXPECT_FALSE(sampler.find({0.3, 0.4, 1 + 1.01 * half}, glm::dvec3(0), place));
    EXPECT_FALSE(sampler.find({kNan, 0.4, 0.5}, glm::dvec3(0), place));
    EXPECT_FALSE(sampler.find({1e30, 1e30, 1e30}, glm::dvec3(0), place));
}

TEST(CellSampler, CellsWithoutAVolumeHoldNothing)
{
    auto cells = makeVolume({2, 2, 2}, unitBox, linearFlow);
    addCell(*cells, Shape::hexahedron, {0, 0, 0, 0, 0, 0, 0, 0});
    addCell(*cells, Shape::tetra, {0, 1, 2, 2});
    addCell(*cells, Shape::wedge, {0, 1, 3, 0, 1, 3});
    const CellSampler sampler(cells);
    CellPlace place;
    for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(0.2, 0.1, 0), glm::dvec3(0.1, 0.1, 0.1)}) {
        ASSERT_TRUE(sampler.find(p, glm::dvec3(0, 0, 1), place));
        EXPECT_LT(place.cell, 8u);
        EXPECT_LT(glm::length(sampler.vectorAt(place) - linearFlow(p.x, p.y, p.z)), 1e-6);
    }
    auto flat = std::make_shared<VolumeCells>();
    flat->points = {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)};
    flat->vectors.assign(3, glm::vec3(1, 2, 3));
    addCell(*flat, Shape::tetra, {0, 1, 2, 2});
    const CellSampler ofFlat(flat);
    EXPECT_FALSE(ofFlat.findWithin({0.2, 0.2, 0.001}, place));
    ASSERT_TRUE(ofFlat.find({0.2, 0.2, 0.1}, glm::dvec3(0), place));
    EXPECT_LT(glm::length(ofFlat.vectorAt(place) - glm::dvec3(1, 2, 3)), 1e-6);
}

TEST(CellSampler, ACornerThatIsMaskedMasksItsCellsAlone)
{
    auto cells = makeVolume({2, 1, 1}, unitBox, linearFlow);
    cells->vectors[0].y = kNan;
    const CellSampler sampler(cells);
    CellPlace place;
    ASSERT_TRUE(sampler.find({0.4, 0.9, 0.9}, glm::dvec3(0), place));
    EXPECT_TRUE(std::isnan(glm::length(sampler.vectorAt(place))));
    ASSERT_TRUE(sampler.find({0.6, 0.9, 0.9}, glm::dvec3(0), place));
    EXPECT_FALSE(std::isnan(glm::length(sampler.vectorAt(place))));
}

TEST(CellSampler, OnAFaceTheCellWithTheLowestNumberIsTaken)
{
    const CellSampler sampler(makeVolume({8, 8, 8}, unitBox, linearFlow));
    CellPlace place;
    ASSERT_TRUE(sampler.find({0.5, 0.5, 0.5}, glm::dvec3(0), place));
    EXPECT_EQ(place.cell, (3u * 8 + 3) * 8 + 3);
    ASSERT_TRUE(sampler.find({0.5, 0.5, -0.01}, glm::dvec3(0), place));
    EXPECT_EQ(place.cell, 3u * 8 + 3);
}

}  // namespace
}  // namespace aeolic
