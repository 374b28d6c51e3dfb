#include "data/mesh/join_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aeolic {
namespace {

/// One triangle about `origin`, of which every value tells `number`.
SurfaceMesh triangleAt(const glm::dvec3& origin, float number)
{
    SurfaceMesh mesh;
    mesh.originWorld = origin;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, glm::vec3(0, 0, 1));
    mesh.triangles = {{0, 1, 2}};
    mesh.pointVectors.assign(3, glm::vec3(number));
    mesh.pointScalars.assign(3, number);
    return mesh;
}

TEST(JoinMeshes, PointsStayWhereTheyAreInTheWorld)
{
    const SurfaceMesh a = triangleAt({1, 0, 0}, 1), b = triangleAt({0, 5, 0}, 2);
    const SurfaceMesh all = joinMeshes({&a, &b}, {0, 0, 2});
    ASSERT_EQ(all.positions.size(), 6u);
    EXPECT_EQ(all.originWorld + glm::dvec3(all.positions[1]), glm::dvec3(2, 0, 0));
    EXPECT_EQ(all.originWorld + glm::dvec3(all.positions[5]), glm::dvec3(0, 6, 0));
    EXPECT_EQ(all.triangles[1], (std::array<std::uint32_t, 3>{3, 4, 5}));
    EXPECT_EQ(all.surfaceOf, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(all.pointScalars[2], 1);
    EXPECT_EQ(all.pointScalars[3], 2);
    EXPECT_EQ(all.pointVectors[4], glm::vec3(2));
}

TEST(JoinMeshes, WhatIsLeftOutKeepsItsNumber)
{
    const SurfaceMesh a = triangleAt({}, 1), b = triangleAt({}, 2);
    const SurfaceMesh all = joinMeshes({nullptr, &a, nullptr, &b}, {});
    EXPECT_EQ(all.surfaceOf, (std::vector<std::uint8_t>{1, 1, 1, 3, 3, 3}));
    EXPECT_TRUE(joinMeshes({nullptr}, {}).triangles.empty());
}

TEST(JoinMeshes, ASurfaceWithoutValuesHasNone)
{
    SurfaceMesh bare = triangleAt({}, 1);
    bare.pointVectors.clear();
    bare.pointScalars.clear();
    const SurfaceMesh a = triangleAt({}, 2), all = joinMeshes({&bare, &a}, {});
    EXPECT_EQ(all.pointVectors[0], glm::vec3(0));
    EXPECT_TRUE(std::isnan(all.pointScalars[0]));
    EXPECT_EQ(all.pointScalars[3], 2);
    const SurfaceMesh none = joinMeshes({&bare, &bare}, {});
    EXPECT_TRUE(none.pointVectors.empty() && none.pointScalars.empty());
}

/// Two triangles with a common edge: their values meet there without mixing.
TEST(JoinMeshes, ValuesOfTrianglesBecomeThoseOfTheirOwnCorners)
{
    SurfaceMesh steps = triangleAt({}, 0);
    steps.positions.push_back({1, 1, 0});
    steps.normals.push_back({0, 0, 1});
    steps.triangles.push_back({2, 1, 3});
    steps.pointScalars.clear();
    steps.cellScalars = {7, 8};
    steps.pointVectors = {glm::vec3(1), glm::vec3(2), glm::vec3(3), glm::vec3(4)};
    const SurfaceMesh a = triangleAt({}, 9), all = joinMeshes({&steps, &a}, {});
    EXPECT_TRUE(all.cellScalars.empty());
    ASSERT_EQ(all.positions.size(), 9u);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(all.pointScalars[i], i < 3 ? 7 : i < 6 ? 8 : 9) << i;
    EXPECT_EQ(all.pointVectors[3], glm::vec3(3)) << "vectors on points stay what they are";
    EXPECT_EQ(all.positions[5], glm::vec3(1, 1, 0));
}

}  // namespace
}  // namespace aeolic
