#include "data/topology/critical_points.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "data/builtin/surfaces.h"
#include "data/mesh/mesh_tools.h"

namespace aeolic {
namespace {

/// A smooth field without a symmetry.
std::vector<glm::vec3> waves(const SurfaceMesh& mesh, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto draw = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    std::array<glm::dvec3, 4> waveNumber, amplitude;
    for (int i = 0; i < 4; ++i) waveNumber[std::size_t(i)] = 2.0 * draw(), amplitude[std::size_t(i)] = draw();
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) {
        glm::dvec3 sum(0);
        for (std::size_t i = 0; i < 4; ++i)
            sum += std::sin(glm::dot(waveNumber[i], glm::dvec3(p)) + double(i)) * amplitude[i];
        vectors.emplace_back(sum);
    }
    return vectors;
}

std::vector<CriticalPoint> criticalPointsOf(const SurfaceMesh& mesh, const std::vector<glm::vec3>& vectors)
{
    const SurfaceFans fans = surfaceFans(mesh);
    return criticalPoints({mesh, fans, tangentField(mesh, fans, vectors)});
}

int sumOfIndices(const std::vector<CriticalPoint>& points)
{
    int sum = 0;
    for (const CriticalPoint& point : points) sum += point.index;
    return sum;
}

void expectEuler(const SurfaceMesh& mesh, int characteristic)
{
    for (unsigned seed = 0; seed < 100; ++seed)
        ASSERT_EQ(sumOfIndices(criticalPointsOf(mesh, waves(mesh, seed))), characteristic)
            << mesh.triangles.size() << " triangles, seed " << seed;
}

/// Every triangle becomes four.
SurfaceMesh cutByFour(const SurfaceMesh& mesh)
{
    SurfaceMesh finer;
    finer.originWorld = mesh.originWorld;
    for (const Triangle& t : mesh.triangles) {
        const auto at = [&](std::size_t i) { return mesh.positions[t[i % 3]]; };
        const auto middle = [&](std::size_t i) {  // The same from either side.
            const glm::vec3 a = at(i), b = at(i + 1);
            return 0.5f * (a + b);
        };
        const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
            const auto first = std::uint32_t(finer.positions.size());
            finer.positions.insert(finer.positions.end(), {a, b, c});
            finer.triangles.push_back({first, first + 1, first + 2});
        };
        for (std::size_t i = 0; i < 3; ++i) add(at(i), middle(i), middle(i + 2));
        add(middle(0), middle(1), middle(2));
    }
    return finer;
}

/// A flat square of 2 x 2 around the origin, with so many cells each way; points are jittered off their grid.
SurfaceMesh square(int cells, bool jittered)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> some(-0.3f, 0.3f);
    SurfaceMesh mesh;
    const auto n = std::uint32_t(cells + 1);
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const float step = 2.0f / float(cells);
            const float dx = jittered ? some(random) * step : 0, dy = jittered ? some(random) * step : 0;
            mesh.positions.emplace_back(-1 + step * float(i) + dx, -1 + step * float(j) + dy, 0);
        }
    for (std::uint32_t j = 0; j + 1 < n; ++j)
        for (std::uint32_t i = 0; i + 1 < n; ++i) {
            const std::uint32_t a = j * n + i;
            mesh.triangles.push_back({a, a + 1, a + n + 1});
            mesh.triangles.push_back({a, a + n + 1, a + n});
        }
    return mesh;
}

std::vector<glm::vec3> linear(const SurfaceMesh& mesh, const glm::mat2& derivative, const glm::vec2& zero)
{
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) vectors.emplace_back(derivative * (glm::vec2(p) - zero), 0.0f);
    return vectors;
}

glm::mat2 rows(float a, float b, float c, float d)
{
    return {a, c, b, d};
}

TEST(CriticalPoints, IndicesSumUpToTheEulerCharacteristicOfASphere)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:2000");
    expectEuler(sphere, 2);
    expectEuler(cutByFour(sphere), 2);
}

TEST(CriticalPoints, IndicesSumUpToTheEulerCharacteristicOfATorus)
{
    const SurfaceMesh torus = makeBuiltinSurface("torus:2000");
    expectEuler(torus, 0);
    expectEuler(cutByFour(torus), 0);
}

TEST(CriticalPoints, ACreasedMeshOfSeparateTrianglesIsWhole)
{
    SurfaceMesh sphere = makeBuiltinSurface("sphere:500");
    computeSmoothNormals(sphere, 1);  // Splits nearly all points.
    expectEuler(sphere, 2);
}

TEST(CriticalPoints, LinearFieldsHaveTheirKindAtTheirPlace)
{
    const SurfaceMesh mesh = square(20, true);
    const glm::vec2 zero(0.137f, -0.264f);
    struct Case {
        glm::mat2 derivative;
        int index;
        CriticalKind kind;
        bool attracts;
    };
    const Case cases[] = {{rows(1, 0, 0, 2), 1, CriticalKind::node, false},
                          {rows(-1, 0, 0, -1), 1, CriticalKind::node, true},
                          {rows(-0.2f, -1, 1, -0.2f), 1, CriticalKind::focus, true},
                          {rows(0.2f, 1, -1, 0.2f), 1, CriticalKind::focus, false},
                          {rows(0, -1, 1, 0), 1, CriticalKind::centre, false},
                          {rows(0, 2, -2, 0), 1, CriticalKind::centre, false},
                          {rows(1, 0, 0, -1), -1, CriticalKind::saddle, false},
                          {rows(0.3f, 1, 1, -0.5f), -1, CriticalKind::saddle, false}};
    for (const Case& c : cases) {
        const std::vector<CriticalPoint> found = criticalPointsOf(mesh, linear(mesh, c.derivative, zero));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].index, c.index);
        EXPECT_EQ(found[0].kind, c.kind);
        EXPECT_TRUE(c.kind == CriticalKind::centre || found[0].attracts == c.attracts);
        EXPECT_LT(glm::length(glm::vec2(positionWorld(mesh, found[0].place)) - zero), 1e-5f);
        EXPECT_NEAR(found[0].strength, std::sqrt(std::abs(glm::determinant(c.derivative))), 1e-4);
    }
}

TEST(CriticalPoints, AWholeTurnAroundAPointOfTheMeshIsFoundOnce)
{
    const SurfaceMesh mesh = square(4, false);
    for (const glm::mat2& derivative : {rows(-1, 0, 0, -1), rows(0, -1, 1, 0), rows(1, 0, 0, -1)}) {
        const std::vector<CriticalPoint> found = criticalPointsOf(mesh, linear(mesh, derivative, {0, 0}));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].index, glm::determinant(derivative) > 0 ? 1 : -1);
        EXPECT_LT(glm::length(positionWorld(mesh, found[0].place)), 1e-12);
    }
}

TEST(CriticalPoints, FieldsThatDoNotVanishHaveNone)
{
    const SurfaceMesh mesh = square(10, true);
    EXPECT_TRUE(criticalPointsOf(mesh, std::vector<glm::vec3>(mesh.positions.size(), {1, 2, 3})).empty());
    EXPECT_TRUE(criticalPointsOf(mesh, std::vector<glm::vec3>(mesh.positions.size(), {0, 0, 0})).empty());
    EXPECT_TRUE(criticalPointsOf(mesh, std::vector<glm::vec3>(mesh.positions.size(), {0, 0, 1})).empty());
}

TEST(CriticalPoints, MaskedPointsHaveNoneAroundThem)
{
    const SurfaceMesh mesh = square(20, true);
    std::vector<glm::vec3> vectors = linear(mesh, rows(-1, 0, 0, -1), {0.03f, 0.02f});
    const std::uint32_t triangle = criticalPointsOf(mesh, vectors)[0].place.triangle;
    vectors[mesh.triangles[triangle][1]] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(criticalPointsOf(mesh, vectors).empty());
}

TEST(CriticalPoints, OneTriangleAlone)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    const std::vector<CriticalPoint> found = criticalPointsOf(mesh, linear(mesh, rows(-1, 0, 0, -2), {0.25f, 0.25f}));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].place.weight[0], 0.5, 1e-6);
    EXPECT_NEAR(found[0].place.weight[1], 0.25, 1e-6);
}

TEST(CriticalPoints, SheetsThatMeetAtAnEdgeAreApart)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};  // Three at the edge from 0 to 1.
    const SurfaceFans fans = surfaceFans(mesh);
    EXPECT_EQ(fans.fans(), 9u);
    EXPECT_TRUE(criticalPointsOf(mesh, std::vector<glm::vec3>(5, {1, 0.3f, 0.2f})).empty());
}

TEST(SurfaceFans, AnglesFillACircle)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:300");
    const SurfaceFans fans = surfaceFans(sphere);
    for (std::size_t fan = 0; fan < fans.fans(); ++fan) {
        ASSERT_TRUE(fans.closed[fan]);
        double sum = 0;
        for (std::uint32_t c = 0; c < 3 * sphere.triangles.size(); ++c)
            if (fans.fanOf[c] == fan) sum += fans.scale[fan] * fans.cornerRad[c];
        EXPECT_NEAR(sum, 2 * 3.14159265358979, 1e-9);
    }
    for (std::uint32_t h = 0; h < fans.twin.size(); ++h)  // There and back changes nothing.
        EXPECT_NEAR(wrapped(fans.transportRad(h) + fans.transportRad(fans.twin[h])), 0, 1e-9);
}

}  // namespace
}  // namespace aeolic
