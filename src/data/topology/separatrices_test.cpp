#include "data/topology/separatrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

TEST(Separatrices, OfASaddleOnAPlaneAreItsAxes)
{
    const SurfaceMesh mesh = makeBuiltinSurface("plane:5000");
    const glm::vec2 zero(0.013f, -0.021f);
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) vectors.emplace_back(p.x - zero.x, zero.y - p.y, 0.0f);
    const SurfaceFans fans = surfaceFans(mesh);
    const TangentField field = tangentField(mesh, fans, vectors);
    const std::vector<CriticalPoint> points = criticalPoints({mesh, fans, field});
    ASSERT_EQ(points.size(), 1u);
    const std::vector<Separatrix> lines = separatrices({mesh, fans, field}, points, 100);
    ASSERT_EQ(lines.size(), 4u);
    const SurfaceTracer tracer({mesh, fans, field});
    double ends = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(lines[k].line.end, LineEnd::boundary);
        EXPECT_EQ(lines[k].direction, k < 2 ? 1 : -1);
        for (const SurfacePlace& place : lines[k].line.places) {
            const glm::dvec3 at = tracer.positionWorld(place);
            if (k < 2)
                ASSERT_NEAR(at.y, zero.y, 1e-4);
            else
                ASSERT_NEAR(at.x, zero.x, 1e-4);
        }
        const glm::dvec3 last = tracer.positionWorld(lines[k].line.places.back());
        ends += last.x + last.y;
    }
    EXPECT_NEAR(ends, 2 * zero.x + 2 * zero.y, 1e-3);  // One to either side of the plane, each way.
}

/// The flow runs away so slowly beside how it comes that it seems to rest near the saddle, wherever that lies in a
/// triangle: within, beside a side, and beside a point.
TEST(Separatrices, OfASaddleThatLeavesSlowlyAreFound)
{
    const SurfaceMesh mesh = makeBuiltinSurface("plane:5000");
    const glm::vec3 point = mesh.positions[mesh.positions.size() / 2 + 7];
    std::vector<glm::vec2> zeros{glm::vec2(point) + glm::vec2(1e-7f, 3e-8f),
                                 glm::vec2(point) + glm::vec2(1e-4f, -2e-5f),
                                 glm::vec2(point) + glm::vec2(-3e-4f, 2e-4f)};
    for (int i = 0; i < 40; ++i) zeros.emplace_back(0.013f + 0.0017f * float(i), -0.021f + 0.0031f * float(i % 7));
    for (const float slowly : {1.0f, 0.03f, 2e-3f})
        for (const float turnRad : {0.0f, 0.4f})
            for (const glm::vec2& zero : zeros) {
                const glm::vec2 out(std::cos(turnRad), std::sin(turnRad)), in(-out.y, out.x);
                std::vector<glm::vec3> vectors;
                for (const glm::vec3& p : mesh.positions) {
                    const glm::vec2 at = glm::vec2(p) - zero;
                    vectors.emplace_back(slowly * glm::dot(at, out) * out - glm::dot(at, in) * in, 0.0f);
                }
                const SurfaceFans fans = surfaceFans(mesh);
                const TangentField field = tangentField(mesh, fans, vectors);
                const std::vector<CriticalPoint> points = criticalPoints({mesh, fans, field});
                ASSERT_EQ(points.size(), 1u) << slowly;
                const std::vector<Separatrix> lines = separatrices({mesh, fans, field}, points, 100);
                EXPECT_GE(lines.size(), 4u) << slowly << " from " << zero.x << ' ' << zero.y;
                for (const Separatrix& line : lines)
                    EXPECT_GT(line.line.lengthWorld, 0.3) << slowly << " from " << zero.x << ' ' << zero.y << ", "
                                                          << line.direction << ", end " << int(line.line.end);
            }
}

/// Columns of points run through the saddle: two of its lines leave the triangle that it is found in at once.
TEST(Separatrices, OfASaddleOnASideLeaveToBothSides)
{
    SurfaceMesh mesh;
    constexpr int kPoints = 21;
    std::vector<glm::vec3> vectors;
    for (int y = 0; y < kPoints; ++y)
        for (int x = 0; x < kPoints; ++x) {
            const glm::vec3 p(0.1f * float(x - 10), 0.1f * float(y - 10), 0);
            mesh.positions.push_back(p);
            mesh.normals.emplace_back(0, 0, 1);
            vectors.emplace_back(-p.x, p.y - 0.01f, 0);
        }
    for (std::uint32_t y = 0; y + 1 < kPoints; ++y)
        for (std::uint32_t x = 0; x + 1 < kPoints; ++x) {
            const std::uint32_t corner = kPoints * y + x;
            mesh.triangles.push_back({corner, corner + 1, corner + kPoints + 1});
            mesh.triangles.push_back({corner, corner + kPoints + 1, corner + kPoints});
        }
    const SurfaceFans fans = surfaceFans(mesh);
    const TangentField field = tangentField(mesh, fans, vectors);
    const std::vector<CriticalPoint> points = criticalPoints({mesh, fans, field});
    ASSERT_EQ(points.size(), 1u);
    const SurfaceTracer tracer({mesh, fans, field});
    std::vector<glm::dvec3> ends;
    for (const Separatrix& separatrix : separatrices({mesh, fans, field}, points, 100)) {
        EXPECT_EQ(separatrix.line.end, LineEnd::boundary);
        ends.push_back(tracer.positionWorld(separatrix.line.places.back()));
    }
    ASSERT_EQ(ends.size(), 4u);
    std::sort(ends.begin(), ends.end(), [](const glm::dvec3& a, const glm::dvec3& b) { return a.x + a.y < b.x + b.y; });
    for (const auto& [i, x, y] : {std::tuple{0, 0.0, -1.0}, {1, -1.0, 0.01}, {2, 0.0, 1.0}, {3, 1.0, 0.01}})
        EXPECT_NEAR(glm::distance(ends[std::size_t(i)], glm::dvec3(x, y, 0)), 0, 1e-4) << i;
}

TEST(Separatrices, RunFromSourcesThroughSaddlesToSinks)
{
    const SurfaceMesh mesh = makeBuiltinSurface("sphere:5000");
    std::vector<glm::vec3> vectors;  // The gradient of a height with two hills, along the sphere.
    for (const glm::vec3& p : mesh.positions) vectors.emplace_back(2 * p.x, 0.5f * p.y, 0.3f);
    const SurfaceFans fans = surfaceFans(mesh);
    const TangentField field = tangentField(mesh, fans, vectors);
    const std::vector<CriticalPoint> points = criticalPoints({mesh, fans, field});
    int saddles = 0, nodes = 0;
    for (const CriticalPoint& point : points) point.kind == CriticalKind::saddle ? ++saddles : ++nodes;
    EXPECT_EQ(nodes - saddles, 2);
    EXPECT_GE(saddles, 1);
    for (const Separatrix& separatrix : separatrices({mesh, fans, field}, points, 100))
        EXPECT_EQ(separatrix.line.end, LineEnd::rest);
}

}  // namespace
}  // namespace aeolic
