#include "data/topology/surface_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

constexpr double kLong = 1000;

/// A surface with a field, and what is needed to trace it.
struct Flow {
    SurfaceMesh mesh;
    SurfaceFans fans;
    TangentField field;
    SurfaceTracer tracer;

    template <class Vector>
    Flow(SurfaceMesh itsMesh, const Vector& vectorAt)
        : mesh(std::move(itsMesh)),
          fans(surfaceFans(mesh)),
          field(tangentField(mesh, fans, vectorsOf(mesh, vectorAt))),
          tracer({mesh, fans, field})
    {
    }

    template <class Vector>
    static std::vector<glm::vec3> vectorsOf(const SurfaceMesh& mesh, const Vector& vectorAt)
    {
        std::vector<glm::vec3> vectors;
        for (const glm::vec3& p : mesh.positions) vectors.push_back(vectorAt(p));
        return vectors;
    }

    /// The middle of the triangle whose middle is nearest.
    SurfacePlace near(const glm::dvec3& point) const
    {
        SurfacePlace best{0, glm::dvec3(1.0 / 3)}, place = best;
        for (place.triangle = 0; place.triangle < mesh.triangles.size(); ++place.triangle)
            if (glm::length(tracer.positionWorld(place) - point) < glm::length(tracer.positionWorld(best) - point))
                best = place;
        return best;
    }
};

TEST(SurfaceTracer, AFlowInCirclesIsClosed)
{
    const Flow flow(makeBuiltinSurface("plane:3000"), [](const glm::vec3& p) { return glm::vec3(-p.y, p.x, 0); });
    for (const int direction : {1, -1}) {
        const SurfacePlace from = flow.near({0.53, 0.21, 0});
        const SurfaceLine line = flow.tracer.trace(from, direction, kLong);
        const double radius = glm::length(flow.tracer.positionWorld(from));
        EXPECT_EQ(line.end, LineEnd::closed);
        EXPECT_NEAR(line.lengthWorld, 2 * std::numbers::pi * radius, 0.1);
        for (const SurfacePlace& place : line.places)
            ASSERT_NEAR(glm::length(flow.tracer.positionWorld(place)), radius, 1e-4);
    }
}

/// A million times as long as wide: steps as short as a triangle is wide would be as many.
TEST(SurfaceTracer, ThinTrianglesTakeFewSteps)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1e-6f, 0}, {0, 1e-6f, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (const float drift : {0.0f, 1e-7f, -1e-7f}) {
        const Flow flow(mesh, [&](const glm::vec3&) { return glm::vec3(1, drift, 0); });
        const SurfaceLine line = flow.tracer.trace({1, {0.5, 0.01, 0.49}}, 1, kLong);
        EXPECT_LE(line.places.size(), 20u) << drift;
        EXPECT_EQ(line.end, LineEnd::boundary) << drift;
        EXPECT_NEAR(flow.tracer.positionWorld(line.places.back()).x, 1, 1e-6) << drift;
    }
}

TEST(SurfaceTracer, AFlowAroundASphereStaysAtItsLatitude)
{
    const Flow flow(makeBuiltinSurface("sphere:3000"), [](const glm::vec3& p) { return glm::vec3(-p.y, p.x, 0); });
    const SurfacePlace from = flow.near({0.8, 0, 0.6});
    const glm::dvec3 start = flow.tracer.positionWorld(from);
    const SurfaceLine line = flow.tracer.trace(from, 1, 2 * std::numbers::pi * glm::length(glm::dvec2(start)));
    for (const SurfacePlace& place : line.places) ASSERT_NEAR(flow.tracer.positionWorld(place).z, start.z, 0.003);
    EXPECT_LT(glm::length(flow.tracer.positionWorld(line.places.back()) - start), 0.03);
}

TEST(SurfaceTracer, LinesPassASaddleAndLeaveThePlane)
{
    const Flow flow(makeBuiltinSurface("plane:3000"), [](const glm::vec3& p) { return glm::vec3(p.x, -p.y, 0); });
    const SurfacePlace from = flow.near({0.1, 0.9, 0});
    const glm::dvec3 start = flow.tracer.positionWorld(from);
    const SurfaceLine line = flow.tracer.trace(from, 1, kLong);
    EXPECT_EQ(line.end, LineEnd::boundary);
    for (const SurfacePlace& place : line.places) {
        const glm::dvec3 at = flow.tracer.positionWorld(place);
        ASSERT_NEAR(at.x * at.y, start.x * start.y, 1e-5);
    }
    EXPECT_NEAR(flow.tracer.positionWorld(line.places.back()).x, 1, 1e-6);
}

TEST(SurfaceTracer, LinesEndWhereTheFlowComesToRest)
{
    const glm::vec3 sink(0.113f, -0.071f, 0);
    const Flow flow(makeBuiltinSurface("plane:3000"), [&](const glm::vec3& p) { return sink - p; });
    const SurfaceLine line = flow.tracer.trace(flow.near({-0.7, 0.6, 0}), 1, kLong);
    EXPECT_EQ(line.end, LineEnd::rest);
    EXPECT_LT(glm::length(flow.tracer.positionWorld(line.places.back()) - glm::dvec3(sink)), 1e-3);
    EXPECT_EQ(flow.tracer.trace(flow.near({-0.7, 0.6, 0}), -1, kLong).end, LineEnd::boundary);
}

TEST(SurfaceTracer, LinesGoThroughPointsAndAlongEdges)
{
    const Flow flow(makeBuiltinSurface("plane:200"), [](const glm::vec3&) { return glm::vec3(1, 0, 0); });
    SurfacePlace from;
    while (glm::length(flow.tracer.positionWorld({from.triangle, {1, 0, 0}}) - glm::dvec3(-1, 0, 0)) > 1e-6)
        ++from.triangle;
    from.weight = {1 - 1e-3, 5e-4, 5e-4};
    const SurfaceLine line = flow.tracer.trace(from, 1, kLong);
    EXPECT_EQ(line.end, LineEnd::boundary);
    EXPECT_NEAR(line.lengthWorld, 2, 0.01);
}

TEST(SurfaceTracer, LinesEndAtTheirLengthAndAtMaskedPoints)
{
    const Flow flow(makeBuiltinSurface("plane:3000"), [](const glm::vec3& p) {
        return p.x > 0.5f ? glm::vec3(std::numeric_limits<float>::quiet_NaN()) : glm::vec3(1, 0, 0);
    });
    const SurfacePlace from = flow.near({-0.5, 0.3, 0});
    const SurfaceLine line = flow.tracer.trace(from, 1, kLong);
    EXPECT_EQ(line.end, LineEnd::masked);
    EXPECT_NEAR(flow.tracer.positionWorld(line.places.back()).x, 0.5, 0.06);
    const SurfaceLine cut = flow.tracer.trace(from, 1, 0.25);
    EXPECT_EQ(cut.end, LineEnd::longest);
    EXPECT_NEAR(cut.lengthWorld, 0.25, 0.03);
}

TEST(SurfaceTracer, FlowsWithoutAnyOrderEnd)
{
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    const Flow flow(makeBuiltinSurface("torus:2000"),
                    [&](const glm::vec3&) { return glm::vec3(normal(random), normal(random), normal(random)); });
    for (std::uint32_t t = 0; t < flow.mesh.triangles.size(); t += 7) {
        const SurfaceLine line = flow.tracer.trace({t, glm::dvec3(1.0 / 3)}, t % 2 == 0 ? 1 : -1, kLong);
        EXPECT_LT(line.places.size(), 100000u);
        for (const SurfacePlace& place : line.places) {
            ASSERT_GE(std::min({place.weight.x, place.weight.y, place.weight.z}), 0);
            ASSERT_NEAR(place.weight.x + place.weight.y + place.weight.z, 1, 1e-9);
        }
    }
}

}  // namespace
}  // namespace aeolic
