#include "data/surface_range.h"

#include <gtest/gtest.h>

#include <limits>

namespace aeolic {
namespace {

/// f = x on [0, 10]^3, samples one apart.
GridField rampField()
{
    GridField field;
    field.dims = {11, 11, 11};
    field.components = 1;
    auto values = std::make_shared<std::vector<float>>(1331);
    for (std::size_t i = 0; i < values->size(); ++i) (*values)[i] = float(i % 11);
    field.samples = std::shared_ptr<const void>(values, values->data());
    return field;
}

SurfaceMesh oneTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    SurfaceMesh mesh;
    mesh.positions = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

TEST(SurfaceRange, OnlyWhatLiesInTheFieldCounts)
{
    const auto range = rangeOnSurface(oneTriangle({-5, 1, 1}, {5, 1, 1}, {5, 2, 1}), rampField());
    ASSERT_TRUE(range);
    EXPECT_NEAR((*range)[0], 0, 0.5);
    EXPECT_EQ((*range)[1], 5);
}

TEST(SurfaceRange, InsideATriangleWhoseCornersAreAllOutside)
{
    const auto range = rangeOnSurface(oneTriangle({-40, -40, 5}, {50, -40, 5}, {5, 80, 5}), rampField());
    ASSERT_TRUE(range);
    EXPECT_LT((*range)[0], 1);
    EXPECT_GT((*range)[1], 9);
}

TEST(SurfaceRange, NothingWhereTheSurfaceIsElsewhere)
{
    EXPECT_FALSE(rangeOnSurface(oneTriangle({20, 0, 0}, {30, 0, 0}, {20, 9, 0}), rampField()));
}

TEST(SurfaceRange, NanAndInfinityAreNoValues)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(finiteRange({nan, 3, -infinity, 1}), (std::optional(std::array<double, 2>{1, 3})));
    EXPECT_FALSE(finiteRange({nan, infinity}));
}

TEST(SurfaceRange, MeetsJudgesTrianglesNotTheWholeBounds)
{
    SurfaceMesh mesh = oneTriangle({-1, -1, -1}, {-1, -2, -1}, {-2, -1, -1});
    mesh.positions.insert(mesh.positions.end(), {{11, 11, 11}, {11, 12, 11}, {12, 11, 11}});
    mesh.triangles.push_back({3, 4, 5});
    EXPECT_FALSE(meets(mesh, boundsOf(rampField()))) << "one on each side, none inside";
    mesh.positions[3] = {9, 9, 9};
    EXPECT_TRUE(meets(mesh, boundsOf(rampField())));
}

}  // namespace
}  // namespace aeolic
