#include "data/builtin/teapot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

#include "data/mesh/testing/mesh_topology_testing.h"

namespace aeolic {
namespace {

glm::dvec3 worldOf(const SurfaceMesh& mesh, std::size_t point)
{
    return mesh.originWorld + glm::dvec3(mesh.positions[point]);
}

/// The normals of all points within 1e-6 of `at`.
std::vector<glm::vec3> normalsAt(const SurfaceMesh& mesh, const glm::dvec3& at)
{
    std::vector<glm::vec3> found;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (glm::distance(worldOf(mesh, i), at) < 1e-6) found.push_back(mesh.normals[i]);
    }
    return found;
}

TEST(Teapot, CountsAreTheSmallestEvenTessellationThatSuffices)
{
    EXPECT_EQ(makeTeapot(2).triangles.size(), 240u);
    EXPECT_EQ(makeTeapot(240).triangles.size(), 240u);
    EXPECT_EQ(makeTeapot(241).triangles.size(), 552u);
    EXPECT_EQ(makeTeapot(25'000).triangles.size(), 25'440u);
}

TEST(Teapot, BoundsAreThoseOfTheData)
{
    const Bounds bounds = makeTeapot(25'000).bounds();
    // The spout's lip bulges furthest where its outer curve's x (3.3, 3.525, 3.45, 3.2) has no slope: 0.125 t^2 - 0.6 t
    // + 0.225 = 0.
    const double t = (0.6 - std::sqrt(0.36 - 4 * 0.125 * 0.225)) / 0.25, s = 1 - t;
    const double lip = 3.3 * s * s * s + 3.525 * 3 * s * s * t + 3.45 * 3 * s * t * t + 3.2 * t * t * t;
    EXPECT_NEAR(lip, 3.434, 1e-3);
    EXPECT_NEAR(bounds.lo.x, -3, 1e-6);
    EXPECT_NEAR(bounds.hi.x, lip, 1e-3);
    EXPECT_NEAR(bounds.lo.y, -2, 1e-6);
    EXPECT_NEAR(bounds.hi.y, 2, 1e-6);
    EXPECT_NEAR(bounds.lo.z, 0, 1e-6);
    EXPECT_NEAR(bounds.hi.z, 3.15, 1e-6);
}

TEST(Teapot, PatchesMeetBitByBit)
{
    for (const std::size_t n : {2u, 3u, 7u, 20u}) {
        SCOPED_TRACE(n);
        const MeshTopology topology = topologyOf(makeTeapot(std::int64_t(64 * n * n - 8 * n)));
        // Open are the rim and the lid (four patches each), and both ends of handle and spout (two patches each).
        EXPECT_EQ(topology.boundaryEdges, (4 + 4 + 2 * 2 + 2 * 2) * n);
        EXPECT_EQ(topology.unevenEdges, 0u);
        // Two discs (body, lid) and two tubes; the handle's end touches the body in one of its data points, (-2, 0,
        // 0.9).
        EXPECT_EQ(topology.eulerCharacteristic, 1 + 1 + 0 + 0 - 1);
    }
}

TEST(Teapot, NormalsOfTheDegeneratePointsStandOnTheAxis)
{
    const SurfaceMesh teapot = makeTeapot(2000);
    const std::vector<glm::vec3> tip = normalsAt(teapot, {0, 0, 3.15}), bottom = normalsAt(teapot, {0, 0, 0});
    ASSERT_FALSE(tip.empty());
    ASSERT_FALSE(bottom.empty());
    for (const glm::vec3& n : tip) EXPECT_LT(glm::distance(n, glm::vec3(0, 0, 1)), 1e-6);
    for (const glm::vec3& n : bottom) EXPECT_LT(glm::distance(n, glm::vec3(0, 0, -1)), 1e-6);
}

TEST(Teapot, NormalsPointOutwards)
{
    const SurfaceMesh teapot = makeTeapot(2000);
    const auto expectNormal = [&](const glm::dvec3& at, const glm::vec3& normal) {
        const std::vector<glm::vec3> found = normalsAt(teapot, at);
        EXPECT_FALSE(found.empty());
        for (const glm::vec3& n : found)
            EXPECT_LT(glm::distance(n, normal), 1e-6) << at.x << " " << at.y << " " << at.z;
    };
    expectNormal({2, 0, 0.9}, {1, 0, 0});  // The belly.
    expectNormal({0, -2, 0.9}, {0, -1, 0});
    expectNormal({0, 2, 0.9}, {0, 1, 0});
    expectNormal({-3, 0, 1.8}, {-1, 0, 0});   // Handle, outside and
    expectNormal({-2.7, 0, 1.8}, {1, 0, 0});  // inside of its bend.
}

TEST(Teapot, NormalsAreThoseTheTrianglesConvergeTo)
{
    // The spout's lip is tight: of 25,000 triangles one is still 37 degrees off its corners' normals. The error is that
    // of a second order tessellation: twice the segments, a quarter of it.
    const double coarse = 1 - worstNormalAgreement(makeTeapot(64 * 32 * 32 - 8 * 32));
    const double fine = 1 - worstNormalAgreement(makeTeapot(64 * 64 * 64 - 8 * 64));
    EXPECT_LT(coarse, 0.1);
    EXPECT_LT(fine, coarse / 3);
}

TEST(Teapot, PatchesThatMeetAgreeOnTheNormal)
{
    const SurfaceMesh teapot = makeTeapot(25'000);
    std::map<std::tuple<float, float, float>, glm::vec3> normalAt;
    const glm::dvec3 contact(-2, 0, 0.9);  // Where handle and body meet, which are not smooth there.
    std::size_t shared = 0;
    for (std::size_t i = 0; i < teapot.positions.size(); ++i) {
        const glm::vec3& p = teapot.positions[i];
        const auto [entry, isNew] = normalAt.emplace(std::tuple(p.x, p.y, p.z), teapot.normals[i]);
        if (isNew || glm::distance(worldOf(teapot, i), contact) < 1e-6) continue;
        ++shared;
        EXPECT_LT(glm::distance(entry->second, teapot.normals[i]), 1e-5) << p.x << " " << p.y << " " << p.z;
    }
    EXPECT_GT(shared, 1000u);
}

TEST(Teapot, ThePictureOfItDoesNotDependOnTheRun)
{
    const SurfaceMesh one = makeTeapot(100'000), two = makeTeapot(100'000);
    EXPECT_EQ(one.triangles, two.triangles);
    EXPECT_EQ(0, std::memcmp(one.positions.data(), two.positions.data(), one.positions.size() * sizeof(glm::vec3)));
    EXPECT_EQ(0, std::memcmp(one.normals.data(), two.normals.data(), one.normals.size() * sizeof(glm::vec3)));
}

}  // namespace
}  // namespace aeolic
