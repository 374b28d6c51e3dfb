#include "data/streamlines/separation_lines.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/mixed_bits.h"
#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

using Field = std::function<glm::vec3(const glm::vec3&)>;

struct FoundLine {
    SeparationLine line;
    std::vector<glm::dvec3> places;
};

std::vector<FoundLine> foundOn(const SurfaceMesh& mesh, const Field& flow, double persistence = 0.01)
{
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) vectors.push_back(flow(p));
    std::vector<FoundLine> found;
    for (const SeparationLine& line : separationLines(StreamlineSurface(mesh, vectors), persistence)) {
        found.push_back({line, {}});
        for (const SurfacePlace& place : line.places) found.back().places.push_back(positionWorld(mesh, place));
    }
    return found;
}

std::vector<FoundLine> foundOn(const std::string& builtin, const Field& flow, double persistence = 0.01)
{
    return foundOn(makeBuiltinSurface(builtin), flow, persistence);
}

/// Runs along x and comes together at y = 0, or parts there.
Field towards(double rate)
{
    return [=](const glm::vec3& at) { return glm::vec3(1, rate * double(at.y), 0); };
}

/// All lines lie at y = 0, and lead downstream. Returns how long they are together.
double lengthAtZero(const std::vector<FoundLine>& found, bool separates)
{
    double length = 0;
    for (const FoundLine& each : found) {
        EXPECT_EQ(each.line.separates, separates);
        EXPECT_GT(each.line.strength, std::log(2));
        length += each.line.lengthWorld;
        for (std::size_t i = 0; i < each.places.size(); ++i) {
            EXPECT_NEAR(each.places[i].y, 0, 0.05);
            EXPECT_TRUE(i == 0 || each.places[i].x > each.places[i - 1].x) << "downstream";
        }
    }
    return length;
}

TEST(SeparationLines, AreWhereStreamlinesComeTogether)
{
    const auto found = foundOn("plane:8000", towards(-6));
    EXPECT_LE(found.size(), 2u);
    EXPECT_GT(lengthAtZero(found, true), 1);
}

/// Half axes 2, 1, 1. The flow runs from both ends to a circle around the long axis, and turns into it.
TEST(SeparationLines, OnAnEllipsoidLieWithinAnEdgeOfWhereTheFlowMeets)
{
    SurfaceMesh mesh = makeBuiltinSurface("sphere:5000");
    float radius = 0;
    for (const glm::vec3& p : mesh.positions) radius = std::max(radius, glm::length(p));
    for (glm::vec3& p : mesh.positions) p = p / radius * glm::vec3(2, 1, 1);
    constexpr double meets = 105 * std::numbers::pi / 180;
    const auto angleOf = [](const glm::dvec3& p) { return std::acos(std::clamp(p.x / 2, -1.0, 1.0)); };
    const Field flow = [&](const glm::vec3& p) {
        const double angle = angleOf(p), around = std::atan2(double(p.z), double(p.y));
        const glm::dvec3 towardsEnd(-2 * std::sin(angle), std::cos(angle) * std::cos(around),
                                    std::cos(angle) * std::sin(around)),
            turn(0, -std::sin(around), std::cos(around));
        return glm::vec3((meets - angle) * towardsEnd + 0.4 * std::sin(angle) * turn);
    };
    const double area = 21.5, edge = std::sqrt(area / double(mesh.triangles.size()) * 4 / std::sqrt(3.0));
    const double perRadian = std::hypot(2 * std::sin(meets), std::cos(meets));
    const std::vector<FoundLine> found = foundOn(mesh, flow);
    double length = 0;
    for (const FoundLine& each : found) {
        EXPECT_TRUE(each.line.separates);
        length += each.line.lengthWorld;
        for (const glm::dvec3& place : each.places)
            EXPECT_NEAR(angleOf(place), meets, edge / perRadian) << place.x << ' ' << place.y << ' ' << place.z;
    }
    EXPECT_GT(length, 0.9 * 2 * std::numbers::pi * std::sin(meets));
}

TEST(SeparationLines, OfAttachmentAreWhereStreamlinesPart)
{
    const auto found = foundOn("plane:8000", towards(6));
    EXPECT_LE(found.size(), 2u);
    EXPECT_GT(lengthAtZero(found, false), 1);
}

/// Parallel flow, one that turns, and one that runs into a point from all sides have none.
TEST(SeparationLines, AreNotWhereStreamlinesOnlyPass)
{
    EXPECT_TRUE(foundOn("plane:8000", [](const glm::vec3&) { return glm::vec3(1, 0.3, 0); }).empty());
    EXPECT_TRUE(foundOn("torus:8000", [](const glm::vec3& at) { return glm::vec3(-at.y, at.x, 0); }).empty());
    EXPECT_TRUE(foundOn("plane:8000", [](const glm::vec3& at) { return -at; }).empty());
    EXPECT_TRUE(
        foundOn("plane:8000", [](const glm::vec3& at) { return glm::vec3(at.y - at.x, -at.x - at.y, 0); }).empty());
    EXPECT_TRUE(foundOn("sphere:8000", [](const glm::vec3&) { return glm::vec3(1, 0, 0); }).empty());
}

TEST(SeparationLines, StayWhereTheDataAreNoisy)
{
    std::uint64_t which = 0;
    const auto noise = [&] { return 0.6 * (double(mixedBits(++which) >> 11) * 0x1p-53 - 0.5); };
    const auto found = foundOn(
        "plane:8000", [&](const glm::vec3& at) { return glm::vec3(1 + noise(), -6 * double(at.y) + noise(), 0); });
    ASSERT_FALSE(found.empty());
    for (const glm::dvec3& place : found[0].places) EXPECT_NEAR(place.y, 0, 0.1);
}

TEST(SeparationLines, AreFewerWithALargerPersistence)
{
    const Field twice = [](const glm::vec3& at) { return glm::vec3(1, std::sin(60 * at.y), 0); };
    const auto fine = foundOn("plane:20000", twice, 0.005), coarse = foundOn("plane:20000", twice, 0.1);
    EXPECT_GT(fine.size(), 4u);
    for (std::size_t i = 1; i < fine.size(); ++i) {
        const SeparationLine &before = fine[i - 1].line, &line = fine[i].line;
        EXPECT_TRUE(before.separates != line.separates ? before.separates : before.strength >= line.strength);
    }
    EXPECT_LT(coarse.size(), fine.size());
    EXPECT_GT(lengthAtZero(foundOn("plane:8000", towards(-6), 0), true), 1) << "the least there is";
}

TEST(SeparationLines, NothingFlowsNothingIsFound)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(foundOn("plane:200", [](const glm::vec3&) { return glm::vec3(0); }).empty());
    EXPECT_TRUE(foundOn("plane:200", [](const glm::vec3&) { return glm::vec3(nan); }).empty());
    EXPECT_TRUE(foundOn("plane:200", [](const glm::vec3&) { return glm::vec3(0, 0, 1); }).empty());
}

TEST(SeparationLines, AreTheSameFromOneThread)
{
    const auto many = foundOn("plane:8000", towards(-6));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = foundOn("plane:8000", towards(-6));
    ASSERT_EQ(alone.size(), many.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(alone[i].line.strength, many[i].line.strength);
        EXPECT_EQ(alone[i].places, many[i].places);
    }
}

}  // namespace
}  // namespace aeolic
