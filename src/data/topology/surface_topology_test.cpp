#include "data/topology/surface_topology.h"

#include <gtest/gtest.h>

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
    const SurfaceTopology all = surfaceTopology(sphere, vectors, {.persistence = 0}),
                          kept = surfaceTopology(sphere, vectors, {.persistence = 0.1});
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

}  // namespace
}  // namespace aeolic
