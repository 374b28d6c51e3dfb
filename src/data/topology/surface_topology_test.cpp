#include "data/topology/surface_topology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

/// From one pole of a sphere to the other, with noise.
std::vector<glm::vec3> fromPoleToPole(const SurfaceMesh& sphere, float noise)
{
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> vectors;
    for (std::size_t i = 0; i < sphere.positions.size(); ++i)
        vectors.push_back(glm::vec3(0, 0, 1) + noise * glm::vec3(normal(random), normal(random), normal(random)));
    return vectors;
}

int sumOfIndices(const SurfaceTopology& topology)
{
    int sum = 0;
    for (const CriticalPoint& point : topology.points) sum += point.index;
    return sum;
}

TEST(SurfaceTopology, NoiseCancels)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:5000");
    const std::vector<glm::vec3> vectors = fromPoleToPole(sphere, 0.5f);
    const SurfaceTopology all = surfaceTopology(sphere, vectors, 0), kept = surfaceTopology(sphere, vectors, 0.1);
    EXPECT_GT(all.points.size(), 20u);
    EXPECT_LE(kept.points.size(), all.points.size() / 3);
    EXPECT_EQ(sumOfIndices(all), 2);
    EXPECT_EQ(sumOfIndices(kept), 2);
    for (const TopologyLine& line : kept.lines) {
        EXPECT_EQ(kept.points[line.saddle].kind, CriticalKind::saddle);
        if (!line.other) continue;
        EXPECT_NE(kept.points[*line.other].kind, CriticalKind::saddle);
    }
}

TEST(SurfaceTopology, WithoutNoiseAllStays)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:5000");
    const SurfaceTopology topology = surfaceTopology(sphere, fromPoleToPole(sphere, 0));
    ASSERT_EQ(topology.points.size(), 2u);
    EXPECT_NE(topology.points[0].attracts, topology.points[1].attracts);
    EXPECT_TRUE(topology.lines.empty());
}

TEST(SurfaceTopology, LinesJoinASaddleWithTheNodesBesideIt)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:5000");
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : sphere.positions) vectors.emplace_back(2 * p.x, 0.5f * p.y, 0.3f);
    const SurfaceTopology topology = surfaceTopology(sphere, vectors);
    EXPECT_EQ(sumOfIndices(topology), 2);
    ASSERT_FALSE(topology.lines.empty());
    for (const TopologyLine& line : topology.lines) {
        ASSERT_TRUE(line.other);
        EXPECT_EQ(topology.points[*line.other].attracts, line.direction == 1);
        const SurfacePlace last = line.places.back(), point = topology.points[*line.other].place;
        EXPECT_EQ(positionWorld(sphere, last), positionWorld(sphere, point));
    }
}

/// Exactly at rest at a point of the mesh, as symmetric data are: one saddle, with the four lines that its axes are,
/// however the triangles around it lie.
TEST(SurfaceTopology, ASaddleAtAPointHasItsFourLines)
{
    constexpr int side = 21, middle = side / 2;
    SurfaceMesh mesh;
    std::vector<glm::vec3> vectors;
    for (const double turnRad : {0.0, 0.3, 0.785398163397448, 2.0}) {
        mesh = {};
        vectors.clear();
        const glm::vec2 out(std::cos(turnRad), std::sin(turnRad)), in(-out.y, out.x);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::vec2 at(float(x - middle), float(y - middle));
                const glm::vec2 flow = glm::dot(at, out) * out - glm::dot(at, in) * in;
                mesh.positions.emplace_back(at, 0);
                vectors.emplace_back(flow, 0);
                const auto corner = std::uint32_t(y * side + x);
                if (x + 1 < side && y + 1 < side) {
                    mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
                    mesh.triangles.push_back({corner, corner + side + 1, corner + side});
                }
            }
        const SurfaceTopology topology = surfaceTopology(mesh, vectors);
        ASSERT_EQ(topology.points.size(), 1u) << turnRad;
        EXPECT_EQ(topology.points[0].kind, CriticalKind::saddle);
        ASSERT_EQ(topology.lines.size(), 4u) << turnRad;
        glm::dvec3 sum(0);
        for (const TopologyLine& line : topology.lines) {
            const glm::dvec3 end = positionWorld(mesh, line.places.back());
            EXPECT_GE(std::max(std::abs(end.x), std::abs(end.y)), middle - 1e-6) << "it ends at the border";
            const glm::vec2 axis = line.direction > 0 ? out : in;
            EXPECT_NEAR(std::abs(glm::dot(glm::normalize(glm::dvec2(end)), glm::dvec2(axis))), 1, 1e-3) << turnRad;
            sum += end;
        }
        EXPECT_LT(glm::length(sum), 1e-3) << "one to each side";
    }
}

/// A vortex of a higher kind is one point.
TEST(SurfaceTopology, APointOfIndexTwoIsOne)
{
    constexpr int side = 21, middle = side / 2;
    SurfaceMesh mesh;
    std::vector<glm::vec3> vectors;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            // Equilateral triangles: between two neighbours the flow turns by a third of a turn.
            const glm::vec2 at(float(x - middle) - 0.5f * float(y - middle), 0.8660254f * float(y - middle));
            mesh.positions.emplace_back(at, 0);
            vectors.emplace_back(at.x * at.x - at.y * at.y, 2 * at.x * at.y, 0);
            const auto corner = std::uint32_t(y * side + x);
            if (x + 1 < side && y + 1 < side) {
                mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
                mesh.triangles.push_back({corner, corner + side + 1, corner + side});
            }
        }
    const SurfaceTopology topology = surfaceTopology(mesh, vectors);
    ASSERT_EQ(topology.points.size(), 1u);
    EXPECT_EQ(topology.points[0].index, 2);
    EXPECT_EQ(topology.points[0].kind, CriticalKind::multiple);
}

/// A triangle without a vector is none for lines, also where its neighbours' points are in the same places.
TEST(SurfaceTopology, AMaskedTriangleStaysMasked)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const glm::vec3 masked(std::numeric_limits<float>::quiet_NaN());
    const SurfaceTopology topology =
        surfaceTopology(mesh, {{1, 0, 0}, {-1, 0.5f, 0}, {0, -1, 0}, masked, masked, masked});
    EXPECT_EQ(topology.points.size(), 1u) << "in the triangle that has flow";
    EXPECT_EQ(topology.points.empty() ? 9u : topology.points[0].place.triangle, 0u);
}

/// Noise three times as strong as the flow, in 60,000 triangles, takes a moment, not hours.
TEST(SurfaceTopology, MuchNoiseCancels)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:60000");
    const SurfaceTopology topology = surfaceTopology(sphere, fromPoleToPole(sphere, 3), 0.05);
    EXPECT_EQ(sumOfIndices(topology), 2);
}

}  // namespace
}  // namespace aeolic
