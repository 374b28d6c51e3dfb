#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <numbers>

#include "data/builtin/surfaces.h"
#include "data/mesh/mesh_tools.h"
#include "data/mesh/testing/mesh_topology_testing.h"

namespace aeolic {
namespace {

constexpr std::array<std::array<std::uint32_t, 3>, 12> cubeTriangles{{{0, 2, 1},
                                                                      {1, 2, 3},
                                                                      {4, 5, 6},
                                                                      {5, 7, 6},
                                                                      {0, 1, 4},
                                                                      {1, 5, 4},
                                                                      {2, 6, 3},
                                                                      {3, 6, 7},
                                                                      {0, 4, 2},
                                                                      {2, 4, 6},
                                                                      {1, 3, 5},
                                                                      {3, 7, 5}}};

/// The cube [-1, 1]^3: eight points, wound outwards.
SurfaceMesh makeCube()
{
    SurfaceMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    mesh.triangles.assign(cubeTriangles.begin(), cubeTriangles.end());
    return mesh;
}

TEST(SmoothNormals, ACubeAtTwentyDegreesKeepsTwentyFourNormals)
{
    SurfaceMesh cube = makeCube();
    for (int i = 0; i < 8; ++i) {
        cube.pointScalars.push_back(float(i));
        cube.pointVectors.push_back(glm::vec3(float(i)));
    }
    computeSmoothNormals(cube, 20);
    ASSERT_EQ(cube.positions.size(), 24u);
    EXPECT_NEAR(worstNormalAgreement(cube), 1, 1e-6);
    const SurfaceMesh original = makeCube();
    ASSERT_EQ(cube.pointScalars.size(), 24u);
    ASSERT_EQ(cube.pointVectors.size(), 24u);
    for (std::size_t i = 0; i < 24; ++i) {
        EXPECT_EQ(cube.positions[i], original.positions[std::size_t(cube.pointScalars[i])])
            << "copies carry their data";
        EXPECT_EQ(cube.pointVectors[i], glm::vec3(cube.pointScalars[i]));
    }
    EXPECT_EQ(topologyOf(cube).eulerCharacteristic, 2);
}

TEST(SmoothNormals, ACubeAtAHundredDegreesHasEightDiagonalNormals)
{
    SurfaceMesh cube = makeCube();
    computeSmoothNormals(cube, 100);
    ASSERT_EQ(cube.positions.size(), 8u);
    // Weighted by angle each side counts for 90 degrees, however many triangles it is cut into.
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_LT(glm::distance(cube.normals[i], cube.positions[i] / std::sqrt(3.0f)), 1e-6);
    }
}

TEST(SmoothNormals, TheFeatureAngleItselfIsStillSmooth)
{
    SurfaceMesh cube = makeCube();
    computeSmoothNormals(cube, 90);
    EXPECT_EQ(cube.positions.size(), 8u);
    cube = makeCube();
    computeSmoothNormals(cube, 89.9);
    EXPECT_EQ(cube.positions.size(), 24u);
    cube = makeCube();
    computeSmoothNormals(cube, 0);
    EXPECT_EQ(cube.positions.size(), 24u) << "coplanar triangles stay together";
}

TEST(SmoothNormals, AFewTrianglesWoundTheOtherWayAreTurnedRound)
{
    SurfaceMesh sphere = makeBuiltinSurface("sphere:5000");
    const std::vector<glm::vec3> exact = sphere.normals;
    for (std::size_t t = 0; t < sphere.triangles.size(); t += 3) {  // The first one among them.
        std::swap(sphere.triangles[t][0], sphere.triangles[t][1]);
    }
    const std::size_t points = sphere.positions.size();
    computeSmoothNormals(sphere, 30);
    EXPECT_EQ(sphere.positions.size(), points);
    EXPECT_EQ(topologyOf(sphere).unevenEdges, 0u);
    EXPECT_GT(volumeOf(sphere), 0);
    for (std::size_t i = 0; i < points; ++i) EXPECT_GT(glm::dot(sphere.normals[i], exact[i]), 0.999f);
}

TEST(SmoothNormals, FinsOnASheetLeaveTheSheetSmooth)
{
    // Two coplanar triangles on the edge from 0 to 1, and a third standing on it.
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 1, 4}};
    computeSmoothNormals(mesh, 30);
    EXPECT_EQ(mesh.positions.size(), 7u) << "only the fin is split off, at both ends of the edge";
    EXPECT_EQ(mesh.triangles[0][0], mesh.triangles[1][0]);
    EXPECT_EQ(mesh.triangles[0][2], mesh.triangles[1][1]);
    EXPECT_NEAR(worstNormalAgreement(mesh), 1, 1e-6);
}

TEST(SmoothNormals, ABookOfManyPagesIsSharpAtItsSpine)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}};
    constexpr std::uint32_t pages = 20'000;
    for (std::uint32_t i = 0; i < pages; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / pages;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        mesh.triangles.push_back({0, 1, i + 2});
    }
    computeSmoothNormals(mesh, 30);
    EXPECT_EQ(mesh.positions.size(), 3 * std::size_t(pages));
    EXPECT_NEAR(worstNormalAgreement(mesh), 1, 1e-6);
}

TEST(SmoothNormals, AFanOfManyTrianglesSharesItsApex)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 1}};
    constexpr std::uint32_t sides = 50'000;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / sides;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        mesh.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
    }
    computeSmoothNormals(mesh, 20);
    ASSERT_EQ(mesh.positions.size(), std::size_t(sides) + 1);
    EXPECT_LT(glm::distance(mesh.normals[0], glm::vec3(0, 0, 1)), 1e-4);
}

TEST(SmoothNormals, AMoebiusStripGetsOneSeamAndNoCancelledNormal)
{
    SurfaceMesh mesh;
    constexpr std::uint32_t columns = 120;
    for (std::uint32_t i = 0; i < columns; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / columns;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0);
        const glm::dvec3 across = 0.2 * (std::cos(angle / 2) * out + std::sin(angle / 2) * glm::dvec3(0, 0, 1));
        mesh.positions.emplace_back(out - across);
        mesh.positions.emplace_back(out + across);
        const bool last = i + 1 == columns;
        const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({b, c, d});
    }
    computeSmoothNormals(mesh, 60);
    EXPECT_EQ(mesh.positions.size(), 2u * columns + 2u);
    EXPECT_GT(worstNormalAgreement(mesh), 0.9);
}

TEST(SmoothNormals, PointsWithoutTrianglesStillHaveAUnitNormal)
{
    SurfaceMesh cube = makeCube();
    cube.positions.emplace_back(5, 5, 5);
    computeSmoothNormals(cube, 100);
    EXPECT_EQ(cube.normals.size(), 9u);
    EXPECT_LT(worstNormalLength(cube), 1e-6);
    SurfaceMesh empty;
    computeSmoothNormals(empty, 20);
    EXPECT_TRUE(empty.normals.empty());
}

TEST(SmoothNormals, AFlatDoubleSheetDoesNotVanish)
{
    // Front and back of one triangle share all three edges; at 180 degrees they are joined and their sum is zero.
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    computeSmoothNormals(mesh, 180);
    for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(std::abs(n.z), 1, 1e-6);
}

/// CPU time of all threads, so that what else the machine does counts little.
double cpuSeconds(SurfaceMesh& mesh)
{
    const std::clock_t start = std::clock();
    computeSmoothNormals(mesh, 20);
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(SmoothNormals, TakeTimeInProportionToTheTriangles)
{
    SurfaceMesh some = makeBuiltinSurface("torus:62500"), many = makeBuiltinSurface("torus:1000000");
    double someS = cpuSeconds(some), manyS = cpuSeconds(many);
    someS = std::min(someS, cpuSeconds(some));
    manyS = std::min(manyS, cpuSeconds(many));
    EXPECT_LT(manyS, 80 * someS) << "of 16 times as many: 16 to 30 where caches end, 256 where all are compared to all";
}

TEST(SmoothNormals, OfAMillionTrianglesAreTheSameEveryTime)
{
    SurfaceMesh one = makeBuiltinSurface("torus:1000000");
    const std::vector<glm::vec3> exact = one.normals;
    SurfaceMesh two = one;
    computeSmoothNormals(one, 20);
    computeSmoothNormals(two, 20);
    ASSERT_EQ(one.normals.size(), exact.size());
    EXPECT_EQ(0, std::memcmp(one.normals.data(), two.normals.data(), exact.size() * sizeof(glm::vec3)));
    double worst = 1;
    for (std::size_t i = 0; i < exact.size(); ++i) worst = std::min(worst, double(glm::dot(exact[i], one.normals[i])));
    EXPECT_GT(worst, 0.9999);
}

}  // namespace
}  // namespace aeolic
