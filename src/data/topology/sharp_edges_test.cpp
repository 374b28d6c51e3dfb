#include "data/topology/sharp_edges.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aeolic {
namespace {

struct Roof {
    SurfaceMesh mesh;
    std::vector<glm::vec3> vectors;
};

/// Two slopes that meet along the y axis. The flow runs up to the ridge on both, and along it from y = 0.37 to either
/// side. A point on the ridge has one vector, which leads over it. `direction` -1: the other way round.
Roof roof(float steepness, float direction)
{
    constexpr int side = 21, middle = side / 2;
    Roof out;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec2 at(float(x - middle), float(y - middle) + (x == y ? 0.2f : 0.0f));
            out.mesh.positions.emplace_back(at, -steepness * std::abs(at.x));
            const float up = at.x > 0 ? -1.0f : 1.0f;
            out.vectors.push_back(direction * glm::vec3(up, 0.2f * (at.y - 0.37f), at.x == 0 ? 0 : steepness));
            const auto corner = std::uint32_t(y * side + x);
            if (x + 1 == side || y + 1 == side) continue;
            out.mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
            out.mesh.triangles.push_back({corner, corner + side + 1, corner + side});
        }
    return out;
}

TEST(SharpEdges, ALineWhereTheFlowOfBothSidesMeetsIsTheEdge)
{
    for (const float direction : {1.0f, -1.0f}) {
        const Roof sharp = roof(1, direction);
        const SurfaceTopology topology = surfaceTopology(sharp.mesh, sharp.vectors, 0);
        ASSERT_EQ(topology.points.size(), 1u);
        EXPECT_EQ(topology.points[0].kind, CriticalKind::saddle);
        const glm::dvec3 saddle = positionWorld(sharp.mesh, topology.points[0].place);
        EXPECT_NEAR(saddle.x, 0, 1e-12);
        EXPECT_NEAR(saddle.y, 0.37, 0.5);
        int along = 0;
        double reach = 0;
        for (const TopologyLine& line : topology.lines) {
            ASSERT_EQ(positionWorld(sharp.mesh, line.places.front()), saddle);
            if (line.direction != int(direction)) continue;
            ++along;
            double lastY = saddle.y;
            const double way = positionWorld(sharp.mesh, line.places.back()).y - saddle.y;
            for (const SurfacePlace& place : line.places) {
                const glm::dvec3 at = positionWorld(sharp.mesh, place);
                EXPECT_NEAR(at.x, 0, 1e-12);
                EXPECT_NEAR(place.weight.x + place.weight.y + place.weight.z, 1, 1e-12);
                EXPECT_GE((at.y - lastY) * way, -1e-9) << "it never turns back";
                lastY = at.y;
            }
            reach += std::abs(way);
        }
        EXPECT_EQ(along, 2) << direction;
        EXPECT_NEAR(reach, 20, 1.5) << "to both ends of the ridge";
    }
}

/// Beyond y = 3 the flow crosses the ridge. The line leaves it there, and nothing is pulled back to its end.
TEST(SharpEdges, ALineThatLeavesTheEdgeGoesOn)
{
    Roof sharp = roof(1, 1);
    for (std::size_t i = 0; i < sharp.vectors.size(); ++i) {
        const glm::vec3& at = sharp.mesh.positions[i];
        if (at.y > 3) sharp.vectors[i] = glm::vec3(1, 0.2f * (at.y - 0.37f), at.x < 0 ? 1 : at.x > 0 ? -1 : 0);
    }
    int crossed = 0;
    for (const TopologyLine& line : surfaceTopology(sharp.mesh, sharp.vectors, 0).lines) {
        double lengthWorld = 0;
        for (std::size_t i = 1; i < line.places.size(); ++i) {
            const glm::dvec3 at = positionWorld(sharp.mesh, line.places[i]);
            const double step = glm::distance(at, positionWorld(sharp.mesh, line.places[i - 1]));
            EXPECT_LT(step, 1.5) << "no place is far from the one before";
            lengthWorld += step;
            crossed += at.y > 5 && at.x > 1;
        }
        EXPECT_NEAR(line.lengthWorld, lengthWorld, 1e-9);
    }
    EXPECT_GT(crossed, 0);
}

/// On a surface that bends little the line stays where the flow turns round.
TEST(SharpEdges, AFlatEdgeIsNone)
{
    const Roof flat = roof(0.2f, 1);
    double off = 0;
    for (const TopologyLine& line : surfaceTopology(flat.mesh, flat.vectors, 0).lines)
        for (const SurfacePlace& place : line.places)
            if (line.direction > 0) off = std::max(off, std::abs(positionWorld(flat.mesh, place).x));
    EXPECT_GT(off, 0.1);
}

}  // namespace
}  // namespace aeolic
