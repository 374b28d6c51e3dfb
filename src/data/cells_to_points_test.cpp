#include "data/cells_to_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "data/mesh/mesh_tools.h"

namespace aeolic {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Two squares side by side, the second bent upwards by `rise`, cut into triangles of unequal corners.
SurfaceMesh squares(float rise)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, rise}, {2, 1, rise}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    mesh.cellVectors = {{1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, 3, 0}};
    mesh.cellScalars = {10, 10, 30, 30};
    return mesh;
}

TEST(CellsToPoints, MeansByAngleAcrossSmoothEdges)
{
    SurfaceMesh mesh = squares(0);
    computeSmoothNormals(mesh, 20);
    bringCellsToPoints(mesh);
    EXPECT_TRUE(mesh.cellVectors.empty());
    EXPECT_TRUE(mesh.cellScalars.empty());
    ASSERT_EQ(mesh.pointScalars.size(), 6u);
    EXPECT_EQ(mesh.pointScalars[0], 10);
    EXPECT_EQ(mesh.pointScalars[4], 30);
    for (const std::size_t point : {1, 2}) {  // Of which one has one triangle of a square, the other both.
        EXPECT_FLOAT_EQ(mesh.pointScalars[point], 20);
        EXPECT_LT(glm::length(mesh.pointVectors[point] - glm::vec3(0.5f, 1.5f, 0)), 1e-6f);
    }
}

TEST(CellsToPoints, NothingCrossesSharpEdges)
{
    SurfaceMesh mesh = squares(2);
    computeSmoothNormals(mesh, 20);
    bringCellsToPoints(mesh);
    for (std::size_t t = 0; t < 4; ++t)
        for (const std::uint32_t point : mesh.triangles[t]) {
            EXPECT_EQ(mesh.pointScalars[point], t < 2 ? 10 : 30);
            EXPECT_EQ(mesh.pointVectors[point], t < 2 ? glm::vec3(1, 0, 0) : glm::vec3(0, 3, 0));
        }
}

TEST(CellsToPoints, TheSidesOfAThinWallKeepTheirOwn)
{
    for (const bool ownPoints : {false, true}) {  // The back is the same squares, turned round.
        SurfaceMesh mesh = squares(0);
        const auto shift = ownPoints ? std::uint32_t(mesh.positions.size()) : 0;
        if (ownPoints)
            for (std::size_t i = 0; i < 6; ++i) mesh.positions.push_back(glm::vec3(mesh.positions[i]));
        for (std::size_t t = 0; t < 4; ++t) {
            const auto [a, b, c] = mesh.triangles[t];
            mesh.triangles.push_back({a + shift, c + shift, b + shift});
            mesh.cellVectors.emplace_back(0, 0, -1);
            mesh.cellScalars.push_back(-5);
        }
        computeSmoothNormals(mesh, 20);
        bringCellsToPoints(mesh);
        for (std::size_t t = 0; t < 8; ++t)
            for (const std::uint32_t point : mesh.triangles[t]) {
                EXPECT_EQ(mesh.pointScalars[point] < 0, t >= 4) << t;
                EXPECT_EQ(mesh.pointVectors[point] == glm::vec3(0, 0, -1), t >= 4) << t;
            }
    }
}

TEST(CellsToPoints, MaskedTrianglesStayMaskedAndCountForNoOther)
{
    SurfaceMesh mesh = squares(0);
    mesh.cellVectors[2] = glm::vec3(0, kNan, 0);
    mesh.cellScalars[1] = kNan;
    computeSmoothNormals(mesh, 20);
    bringCellsToPoints(mesh);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t t = 0; t < 4; ++t)
        for (const std::uint32_t point : mesh.triangles[t]) {
            EXPECT_EQ(std::isnan(mesh.pointVectors[point].x), t == 2) << t;
            EXPECT_EQ(std::isnan(mesh.pointScalars[point]), t == 1) << t;
        }
    EXPECT_EQ(mesh.pointScalars[mesh.triangles[0][0]], 10);
}

}  // namespace
}  // namespace aeolic
