#include "data/mesh/mesh_tools.h"

#include <gtest/gtest.h>

#include <limits>

namespace aeolic {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(DropDegenerateTriangles, EveryKindGoesAndCellArraysStayInStep)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {nan, 0, 0}, {infinity, 0, 0}, {0, 0, 0}};
    mesh.triangles = {{0, 1, 2},   // Good.
                      {0, 1, 1},   // A repeated index.
                      {0, 1, 3},   // Three points in a row.
                      {1, 2, 3},   // Good.
                      {0, 1, 4},   // Not a number.
                      {0, 2, 5},   // Infinite.
                      {0, 6, 2},   // Two points at one place.
                      {0, 1, 99},  // No such point.
                      {0, 2, 3}};  // Good.
    for (int i = 0; i < 9; ++i) {
        mesh.cellScalars.push_back(float(i));
        mesh.cellVectors.push_back(glm::vec3(float(i)));
    }
    EXPECT_EQ(dropDegenerateTriangles(mesh), 6u);
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {1, 2, 3}, {0, 2, 3}}));
    EXPECT_EQ(mesh.cellScalars, (std::vector<float>{0, 3, 8}));
    EXPECT_EQ(mesh.cellVectors, (std::vector<glm::vec3>{glm::vec3(0), glm::vec3(3), glm::vec3(8)}));
    EXPECT_EQ(mesh.positions.size(), 7u);
    EXPECT_EQ(dropDegenerateTriangles(mesh), 0u);
}

TEST(DropDegenerateTriangles, SizeDoesNotMatterOnlyShape)
{
    for (const float scale : {1e-15f, 1.0f, 1e15f}) {
        SurfaceMesh mesh;
        // A boundary layer's sliver, 1 : 10,000, is data; a height of 1e-8 of the length is rounding.
        mesh.positions = {{0, 0, 0}, {scale, 0, 0}, {0, 1e-4f * scale, 0}, {0.5f * scale, 1e-8f * scale, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
        EXPECT_EQ(dropDegenerateTriangles(mesh), 1u) << scale;
        EXPECT_EQ(mesh.triangles.front(), (std::array<std::uint32_t, 3>{0, 1, 2}));
    }
}

TEST(DropDegenerateTriangles, AnEmptyMeshHasNone)
{
    SurfaceMesh mesh;
    EXPECT_EQ(dropDegenerateTriangles(mesh), 0u);
}

TEST(SurfaceMeshBounds, AreInTheWorldAndIgnorePointsThatAreNotFinite)
{
    SurfaceMesh mesh;
    EXPECT_TRUE(mesh.bounds().empty());
    mesh.originWorld = {1e6, 0, -1e6};
    mesh.positions = {{nan, 0, 0}, {-1, -2, -3}, {0, infinity, 0}, {3, 2, 1}};
    EXPECT_EQ(mesh.bounds().lo, glm::dvec3(1e6 - 1, -2, -1e6 - 3));
    EXPECT_EQ(mesh.bounds().hi, glm::dvec3(1e6 + 3, 2, -1e6 + 1));
}

}  // namespace
}  // namespace aeolic
