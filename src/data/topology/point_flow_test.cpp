#include "data/topology/point_flow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

glm::vec3 turning(const glm::dvec3& at)
{
    return {float(-at.y), float(at.x), 0.5f};
}

SurfaceMesh square(int cells)
{
    return makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, cells);
}

glm::dvec3 worldOf(const SurfaceMesh& mesh, std::size_t point)
{
    return mesh.originWorld + glm::dvec3(mesh.positions[point]);
}

TEST(PointFlow, ASurfacesOwnVectors)
{
    SurfaceMesh mesh = square(5);
    setPointVectors(mesh, turning);
    const PointFlow flow = pointFlow(makeScene(mesh));
    EXPECT_EQ(flow.mesh.triangles, mesh.triangles);
    EXPECT_EQ(flow.vectors, mesh.pointVectors);
}

TEST(PointFlow, ValuesOfTrianglesComeToThePoints)
{
    SurfaceMesh mesh = square(40);
    setCellVectors(mesh, turning);
    const PointFlow flow = pointFlow(makeScene(mesh));
    ASSERT_EQ(flow.vectors.size(), flow.mesh.positions.size());
    for (std::size_t i = 0; i < flow.vectors.size(); ++i)
        EXPECT_LT(glm::length(flow.vectors[i] - turning(worldOf(flow.mesh, i))), 0.06f) << i;
}

TEST(PointFlow, SurfacesStayApartWhereTheyAreMadeFiner)
{
    SurfaceMesh mesh = square(1), beside = makeRectangle({0, 0, 0.5}, {1, 0, 0}, {0, 1, 0}, 1);
    const std::size_t own = mesh.positions.size();
    append(mesh, beside);
    mesh.surfaceOf.assign(mesh.positions.size(), 1);
    std::fill_n(mesh.surfaceOf.begin(), own, std::uint8_t{0});
    Scene scene = makeScene(mesh, makeField({{-1, -1, -1}, {1, 1, 1}}, {21, 21, 21}, turning));
    scene.surfaces = {{.name = "with", .streaks = true}, {.name = "without", .streaks = false}};
    const PointFlow flow = pointFlow(scene);
    ASSERT_EQ(flow.mesh.surfaceOf.size(), flow.vectors.size());
    for (std::size_t i = 0; i < flow.vectors.size(); ++i)
        EXPECT_EQ(std::isnan(flow.vectors[i].x), worldOf(flow.mesh, i).z > 0.25) << i;
}

/// Two triangles would know the field at four points.
TEST(PointFlow, TrianglesBecomeAsFineAsTheFieldsCells)
{
    const Scene scene = makeScene(square(1), makeField({{-1, -1, -1}, {1, 1, 1}}, {21, 21, 21}, turning));
    const PointFlow flow = pointFlow(scene);
    EXPECT_EQ(scene.surface.triangles.size(), 2u);
    EXPECT_GE(flow.mesh.triangles.size(), 400u);  // No edge is much longer than a cell.
    EXPECT_LE(flow.mesh.triangles.size(), 16 * 20 * 20u);
    ASSERT_EQ(flow.vectors.size(), flow.mesh.positions.size());
    for (std::size_t i = 0; i < flow.vectors.size(); ++i)
        EXPECT_LT(glm::length(flow.vectors[i] - turning(worldOf(flow.mesh, i))), 1e-5f) << i;
}

TEST(PointFlow, NothingWhereTheFieldIsNot)
{
    const Scene scene = makeScene(square(20), makeField({{-1, -1, -1}, {0.5, 1, 1}}, {16, 21, 21}, turning));
    const PointFlow flow = pointFlow(scene);
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        const double x = worldOf(flow.mesh, i).x;
        if (std::abs(x - 0.5) > 0.01) {
            EXPECT_EQ(std::isnan(flow.vectors[i].x), x > 0.5) << x;
        }
    }
}

TEST(PointFlow, NothingOnSurfacesWithoutStreaks)
{
    SurfaceMesh mesh = square(2), beside = makeRectangle({5, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
    setPointVectors(mesh, turning);
    setPointVectors(beside, turning);
    const std::size_t own = mesh.positions.size();
    append(mesh, beside);
    mesh.surfaceOf.assign(mesh.positions.size(), 1);
    std::fill_n(mesh.surfaceOf.begin(), own, std::uint8_t{0});
    Scene scene = makeScene(mesh);
    scene.surfaces = {{.name = "with", .streaks = true}, {.name = "without", .streaks = false}};
    const PointFlow flow = pointFlow(scene);
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) EXPECT_EQ(std::isnan(flow.vectors[i].x), i >= own) << i;
}

}  // namespace
}  // namespace aeolic
