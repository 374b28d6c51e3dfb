#include "data/streamlines/streamline_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "base/mixed_bits.h"
#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

std::vector<glm::vec3> flowOn(const SurfaceMesh& mesh, const std::function<glm::vec3(const glm::vec3&)>& flow)
{
    std::vector<glm::vec3> vectors;
    for (const glm::vec3& p : mesh.positions) vectors.push_back(flow(p));
    return vectors;
}

glm::vec3 aroundZ(const glm::vec3& at)
{
    return {-at.y, at.x, 0};
}

double randomPart(std::uint64_t which)
{
    return double(mixedBits(which) >> 11) * 0x1p-53;
}

/// No point of a fine sampling of the triangles is nearer.
TEST(StreamlineSurface, TheNearestPlaceIsTheNearest)
{
    const SurfaceMesh mesh = makeBuiltinSurface("torus:300");
    const StreamlineSurface surface(mesh, flowOn(mesh, aroundZ));
    for (std::uint64_t i = 0; i < 60; ++i) {
        const glm::dvec3 point{3 * randomPart(3 * i) - 1.5, 3 * randomPart(3 * i + 1) - 1.5,
                               2 * randomPart(3 * i + 2) - 1};
        const SurfacePlace found = surface.nearest(point);
        const glm::dvec3 weight = found.weight;
        EXPECT_GE(std::min({weight.x, weight.y, weight.z}), 0);
        EXPECT_NEAR(weight.x + weight.y + weight.z, 1, 1e-12);
        const double distance = glm::length(positionWorld(mesh, found) - point);
        double least = std::numeric_limits<double>::infinity();
        constexpr int parts = 24;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (int u = 0; u <= parts; ++u)
                for (int v = 0; u + v <= parts; ++v) {
                    const glm::dvec3 each{double(parts - u - v) / parts, double(u) / parts, double(v) / parts};
                    least = std::min(least, glm::length(positionWorld(mesh, {t, each}) - point));
                }
        EXPECT_LE(distance, least + 1e-9) << i;
        EXPECT_GE(distance, least - 0.05) << i;
    }
}

TEST(StreamlineSurface, TheLineThroughAPlaceGoesBothWays)
{
    const SurfaceMesh plane = makeBuiltinSurface("plane:2000");
    const StreamlineSurface surface(plane, flowOn(plane, [](const glm::vec3&) { return glm::vec3(2, 0, 1); }));
    const auto unit = float(surface.unitWorld());
    const SurfacePlace place = surface.nearest({0.1, 0.2, 7});
    EXPECT_NEAR(glm::length(positionWorld(plane, place) - glm::dvec3(0.1, 0.2, 0)), 0, 1e-6);
    const auto [comes, leaves] = surface.through(place);
    ASSERT_GT(comes.size(), 2u);
    ASSERT_GT(leaves.size(), 2u);
    for (const auto& part : {comes, leaves})
        for (std::size_t i = 1; i < part.size(); ++i) {
            EXPECT_GE(part[i].x, part[i - 1].x) << "downstream";
            EXPECT_NEAR(part[i].y * unit, 0.2f, 1e-5f);
        }
    EXPECT_NEAR(glm::length(comes.back() - leaves.front()), 0, 1e-6);
    const Bounds bounds = plane.bounds();
    EXPECT_NEAR(comes.front().x * unit, float(bounds.lo.x), 1e-3);
    EXPECT_NEAR(leaves.back().x * unit, float(bounds.hi.x), 1e-3);
}

TEST(StreamlineSurface, ThereIsNoLineWhereNothingFlows)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:500");
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const StreamlineSurface masked(
        sphere, flowOn(sphere, [](const glm::vec3& at) { return at.z > 0 ? glm::vec3(nan) : glm::vec3(1, 0, 0); }));
    const auto none = masked.through(masked.nearest({0, 0, 5}));
    EXPECT_TRUE(none[0].empty() && none[1].empty());
    const auto some = masked.through(masked.nearest({0, 0.1, -5}));
    EXPECT_FALSE(some[0].empty() || some[1].empty());
}

}  // namespace
}  // namespace aeolic
