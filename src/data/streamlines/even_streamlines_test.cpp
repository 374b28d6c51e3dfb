#include "data/streamlines/even_streamlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

using Flow = std::function<glm::vec3(const glm::vec3&)>;

/// The origin of the built-in surfaces is the world's.
EvenStreamlines linesOn(const std::string& surface, const Flow& flow)
{
    const SurfaceMesh mesh = makeBuiltinSurface(surface);
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) vectors.push_back(flow(p));
    return {mesh, vectors};
}

glm::vec3 uniform(const glm::vec3& /*at*/)
{
    return {1, 0, 0};
}
glm::vec3 around(const glm::vec3& at)
{
    return {-at.y, at.x, 0};
}

float distanceTo(const EvenStreamline& line, const glm::vec3& at)
{
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const glm::vec3 a = line.points[i].at, way = line.points[i + 1].at - a;
        const float part = std::clamp(glm::dot(at - a, way) / glm::dot(way, way), 0.0f, 1.0f);
        nearest = std::min(nearest, glm::length(a + part * way - at));
    }
    return nearest;
}

TEST(EvenStreamlines, KeepTheirDistanceAndLeaveNoGaps)
{
    EvenStreamlines all = linesOn("plane:5000", uniform);
    all.refineTo(4);
    ASSERT_EQ(all.levels(), 5);
    const auto spacing = float(all.spacing(4));
    for (const EvenStreamline& line : all.lines()) {
        for (const StreamlinePoint& point : line.points) {
            EXPECT_NEAR(point.at.y, line.points[0].at.y, 1e-4f);
            EXPECT_NEAR(point.normal.z, 1, 1e-6f);
        }
        for (const EvenStreamline& other : all.lines())
            if (other.chain != line.chain) {
                EXPECT_GT(distanceTo(other, line.points[line.points.size() / 2].at), 0.5f * spacing);
            }
    }
    for (const glm::vec3& place : all.places()) {
        float nearest = std::numeric_limits<float>::max();
        for (const EvenStreamline& line : all.lines()) nearest = std::min(nearest, distanceTo(line, place));
        ASSERT_LT(nearest, 1.3f * spacing);
    }
}

TEST(EvenStreamlines, FinerLevelsKeepLinesAndAddOthers)
{
    EvenStreamlines all = linesOn("sphere:5000", around);
    all.refineTo(1);
    const std::vector<EvenStreamline> before = all.lines();
    all.refineTo(3);
    ASSERT_GT(all.lines().size(), 2 * before.size());
    int level = 0;
    for (std::size_t i = 0; i < all.lines().size(); ++i) {
        const EvenStreamline& line = all.lines()[i];
        EXPECT_GE(line.level, level);
        level = line.level;
        if (i >= before.size()) continue;
        ASSERT_EQ(line.points.size(), before[i].points.size());
        for (std::size_t k = 0; k < line.points.size(); ++k) EXPECT_EQ(line.points[k].at, before[i].points[k].at);
    }
}

TEST(EvenStreamlines, DoNotDependOnHowTheLevelsCame)
{
    EvenStreamlines one = linesOn("torus:4000", around), other = linesOn("torus:4000", around);
    one.refineTo(4);
    for (int level = 0; level <= 4; ++level) other.refineTo(level);
    ASSERT_EQ(one.lines().size(), other.lines().size());
    for (std::size_t i = 0; i < one.lines().size(); ++i)
        EXPECT_EQ(one.lines()[i].points.back().at, other.lines()[i].points.back().at);
}

TEST(EvenStreamlines, ThatComeBackAreClosed)
{
    EvenStreamlines all = linesOn("sphere:20000", around);
    all.refineTo(2);
    const auto unit = float(all.unitWorld());
    std::size_t closed = 0;
    for (const EvenStreamline& line : all.lines()) {
        const float height = unit * line.points[0].at.z,
                    length = unit * (line.points.back().arc - line.points.front().arc);
        for (const StreamlinePoint& point : line.points) EXPECT_NEAR(unit * point.at.z, height, 0.02f);
        if (line.points.front().at != line.points.back().at) continue;
        ++closed;
        EXPECT_NEAR(length, 6.2832f * std::sqrt(1 - height * height), 0.05f * length);
    }
    EXPECT_GE(closed, 4u);
}

/// The arc says how far along the line a point is.
TEST(EvenStreamlines, AreMeasuredAlongThem)
{
    EvenStreamlines all = linesOn("sphere:5000", [](const glm::vec3& p) { return glm::vec3(-p.y, p.x, 0.3f); });
    all.refineTo(3);
    for (const EvenStreamline& line : all.lines()) {
        ASSERT_GE(line.points.size(), 2u);
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const float walked = line.points[i].arc - line.points[i - 1].arc,
                        straight = glm::length(line.points[i].at - line.points[i - 1].at);
            EXPECT_GT(walked, 0);
            EXPECT_NEAR(walked, straight, 0.01f * straight + 1e-5f);
        }
    }
}

TEST(EvenStreamlines, WhereNothingFlowsThereAreNone)
{
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    for (const glm::vec3& vector : {glm::vec3(0), glm::vec3(kNaN), glm::vec3(0, 0, 1)}) {
        EvenStreamlines all = linesOn("plane:200", [&](const glm::vec3&) { return vector; });
        all.refineTo(30);
        EXPECT_TRUE(all.lines().empty());
        EXPECT_LE(all.levels(), 12);
    }
}

TEST(EvenStreamlines, OneTriangleHasThem)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    EvenStreamlines all(mesh, {{1, 0.2f, 0}, {1, 0.2f, 0}, {1, 0.2f, 0}});
    all.refineTo(4);
    EXPECT_GE(all.lines().size(), 8u);
}

/// Lengths of any unit give the same lines.
TEST(EvenStreamlines, OfAnyUnitAreTheSame)
{
    const SurfaceMesh mesh = makeBuiltinSurface("sphere:2000");
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) vectors.emplace_back(-p.y, p.x, 0.2f);
    EvenStreamlines usual(mesh, vectors);
    usual.refineTo(3);
    for (const int power : {-60, -40, 40, 98}) {
        SurfaceMesh scaled = mesh;
        for (glm::vec3& p : scaled.positions) p *= std::ldexp(1.0f, power);
        EvenStreamlines other(scaled, vectors);
        other.refineTo(3);
        EXPECT_EQ(other.unitWorld(), std::ldexp(usual.unitWorld(), power));
        ASSERT_EQ(other.lines().size(), usual.lines().size());
        for (std::size_t i = 0; i < usual.lines().size(); ++i)
            ASSERT_EQ(other.lines()[i].points.size(), usual.lines()[i].points.size()) << power;
    }
}

/// Where lines meet, those that were cut go on at finer levels, from where they were.
TEST(EvenStreamlines, PartsOfALineFollowEachOther)
{
    EvenStreamlines all = linesOn("plane:5000", [](const glm::vec3& p) { return glm::vec3(1, -4 * p.y, 0); });
    all.refineTo(5);
    std::size_t more = 0;
    for (const EvenStreamline& line : all.lines())
        for (const EvenStreamline& other : all.lines()) {
            if (&line == &other || line.chain != other.chain) continue;
            ++more;
            const StreamlinePoint &a = line.points.back(), &b = other.points.front();
            const bool isBefore = line.points.front().arc < b.arc;
            if (isBefore) {
                EXPECT_LE(a.arc, b.arc + 1e-5f);
            }
            if (std::abs(a.arc - b.arc) < 1e-6f) {
                EXPECT_LT(glm::length(a.at - b.at), 1e-5f);
            }
        }
    EXPECT_GT(more, 10u);
}

/// Two triangles that are much longer than the spacing.
TEST(EvenStreamlines, GoThroughLongTrianglesToTheirEnd)
{
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {40, 0, 0}, {40, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    EvenStreamlines all(mesh, std::vector<glm::vec3>(4, {1, 0, 0}));
    all.refineTo(10);
    const auto whole = float(40 / all.unitWorld());
    for (const EvenStreamline& line : all.lines())
        EXPECT_NEAR(line.points.back().arc - line.points.front().arc, whole, 0.001f * whole);
}

/// A box whose sides the flow leaves across sharp edges, and along which it meets: no line runs against its vectors.
TEST(EvenStreamlines, RunWithTheVectorsAlsoAtSharpEdges)
{
    SurfaceMesh mesh;
    std::vector<glm::vec3> vectors;
    const auto addSide = [&](const glm::vec3& u, const glm::vec3& v) {
        constexpr int n = 12;
        const auto first = std::uint32_t(mesh.positions.size());
        const glm::vec3 normal = glm::cross(u, v);
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const glm::vec3 at = normal + u * (2 * float(i) / n - 1) + v * (2 * float(j) / n - 1);
                mesh.positions.push_back(at);
                mesh.normals.push_back(normal);
                vectors.push_back(normal.x > 0.5f ? glm::vec3(0.3f, at.y, at.z) : glm::vec3(1, 0.1f, 0.05f * at.z));
            }
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = first + j * (n + 1) + i;
                mesh.triangles.push_back({a, a + 1, a + n + 2});
                mesh.triangles.push_back({a, a + n + 2, a + n + 1});
            }
    };
    for (const float side : {1.0f, -1.0f}) {
        addSide({0, side, 0}, {0, 0, 1});
        addSide({0, 0, side}, {1, 0, 0});
        addSide({side, 0, 0}, {0, 1, 0});
    }
    EvenStreamlines all(mesh, vectors);
    all.refineTo(4);
    std::size_t against = 0, segments = 0;
    for (const EvenStreamline& line : all.lines())
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const StreamlinePoint& a = line.points[i];
            glm::vec3 vector(0);
            for (int k = 0; k < 3; ++k)
                vector += float(a.place.weight[k]) * vectors[mesh.triangles[a.place.triangle][std::size_t(k)]];
            const glm::vec3 way = line.points[i + 1].at - a.at;
            ++segments;
            against += glm::dot(way, vector) < 0 ? 1 : 0;
            // Along an edge at which sides meet a line goes from point to point.
            EXPECT_LT(glm::length(way), std::max(1.1f * float(all.spacing(line.level)), 0.09f));
        }
    EXPECT_GT(segments, 500u);
    EXPECT_LE(against, segments / 200);
}

/// A sheet with two sides, a tenth of the spacing apart: each has lines of its own.
TEST(EvenStreamlines, BothSidesOfAThinPlateHaveThem)
{
    SurfaceMesh mesh = makeBuiltinSurface("plane:2000");
    const auto points = std::uint32_t(mesh.positions.size());
    const std::size_t triangles = mesh.triangles.size();
    for (std::uint32_t i = 0; i < points; ++i) {
        mesh.positions.push_back(mesh.positions[i] - glm::vec3(0, 0, 1e-3f));
        mesh.normals.push_back(-mesh.normals[i]);
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        mesh.triangles.push_back({a + points, c + points, b + points});
    }
    EvenStreamlines all(mesh, std::vector<glm::vec3>(mesh.positions.size(), {1, 0, 0}));
    all.refineTo(3);
    std::size_t below = 0;
    for (const EvenStreamline& line : all.lines()) below += line.points[0].normal.z < 0 ? 1 : 0;
    EXPECT_NEAR(double(below) / double(all.lines().size()), 0.5, 0.1);
}

/// A flow that winds into a point: lines end where they would come too near to themselves.
TEST(EvenStreamlines, ASpiralKeepsItsDistanceFromItself)
{
    EvenStreamlines all =
        linesOn("plane:20000", [](const glm::vec3& p) { return glm::vec3(-p.y - 0.05f * p.x, p.x - 0.05f * p.y, 0); });
    all.refineTo(3);
    const auto spacing = float(all.spacing(3));
    for (const EvenStreamline& line : all.lines())
        for (std::size_t i = 0; i < line.points.size(); i += 5)
            for (std::size_t k = 0; k < i; ++k)
                if (line.points[i].arc - line.points[k].arc > 4 * float(all.spacing(line.level))) {
                    EXPECT_GT(glm::length(line.points[i].at - line.points[k].at), 0.4f * spacing);
                }
}

}  // namespace
}  // namespace aeolic
