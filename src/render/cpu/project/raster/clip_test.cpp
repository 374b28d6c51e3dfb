#include "render/cpu/project/raster/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace aeolic::cpu {
namespace {

using Corners = std::array<glm::dvec3, kMaxClippedCorners>;

double areaOf(const Corners& corners, int count)
{
    glm::dvec3 sum(0);
    for (int i = 2; i < count; ++i)
        sum += glm::cross(corners[std::size_t(i - 1)] - corners[0], corners[std::size_t(i)] - corners[0]);
    return 0.5 * glm::length(sum);
}

TEST(Clip, TriangleInsideStaysAsItIs)
{
    const std::array<glm::dvec3, 3> triangle{{{0, 0, 2}, {1, 0, 2}, {0, 1, 3}}};
    Corners out;
    ASSERT_EQ(clipTriangle(triangle, 1, 1, 1, out), 3);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(out[i], triangle[i]);
}

TEST(Clip, TriangleOutsideIsGone)
{
    Corners out;
    EXPECT_EQ(clipTriangle({{{0, 0, 0.5}, {0.1, 0, 0.5}, {0, 0.1, -3}}}, 1, 1, 1, out), 0);
    EXPECT_EQ(clipTriangle({{{5, 0, 2}, {6, 0, 2}, {5, 1, 2}}}, 1, 1, 1, out), 0);
    EXPECT_EQ(clipTriangle({{{0, -5, 2}, {1, -9, 2}, {0, -5, 3}}}, 1, 1, 1, out), 0);
}

TEST(Clip, NearPlaneCutsOneOrTwoCorners)
{
    Corners out;
    // One corner is left: a quarter of the area. One is cut off: three quarters.
    const std::array<glm::dvec3, 3> oneIn{{{0, 0, 2}, {0.4, 0, 0}, {-0.4, 0, 0}}},
        twoIn{{{0, 0, 0}, {0.4, 0, 2}, {-0.4, 0, 2}}};
    ASSERT_EQ(clipTriangle(oneIn, 1, 1, 1, out), 3);
    EXPECT_NEAR(areaOf(out, 3), 0.25 * 0.8, 1e-12);
    ASSERT_EQ(clipTriangle(twoIn, 1, 1, 1, out), 4);
    EXPECT_NEAR(areaOf(out, 4), 0.75 * 0.8, 1e-12);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_GE(out[i].z, 1 - 1e-12);
}

TEST(Clip, GuardBandTouchesAllFourSides)
{
    Corners out;
    const int count = clipTriangle({{{-30, -30, 2}, {70, -30, 2}, {-30, 70, 2}}}, 1, 1, 1.5, out);
    ASSERT_EQ(count, 4);
    EXPECT_NEAR(areaOf(out, count), 4.0 * 6.0, 1e-9);  // |x| <= 2, |y| <= 3 at depth 2.
}

TEST(Clip, NeverMoreCornersThanThereIsRoomFor)
{
    Corners out;
    int most = 0;
    std::minstd_rand random(1);
    const auto between = [&](double lo, double hi) {
        return lo + (hi - lo) * double(random()) / double(std::minstd_rand::max());
    };
    const auto corner = [&] { return glm::dvec3(between(-4, 4), between(-4, 4), between(-0.5, 3)); };
    for (int i = 0; i < 20000; ++i) {
        const int count = clipTriangle({{corner(), corner(), corner()}}, 0.5, 0.7, 0.4, out);
        most = std::max(most, count);
        for (int k = 0; k < count; ++k) {
            const glm::dvec3& p = out[std::size_t(k)];
            EXPECT_GE(p.z, 0.5 - 1e-9);
            EXPECT_LE(std::abs(p.x), 0.7 * p.z + 1e-9);
            EXPECT_LE(std::abs(p.y), 0.4 * p.z + 1e-9);
        }
    }
    EXPECT_LE(most, kMaxClippedCorners);
    EXPECT_GE(most, 6);
}

/// Two triangles share an edge, walked in opposite directions: the new corners on it have the same bits, hence no gap.
TEST(Clip, SharedEdgesAreCutAtTheSameBits)
{
    const glm::dvec3 a(0.3, 0.1, 0.2), b(-0.7, 0.05, 3.1), left(1.1, -0.4, 2.2), right(-1.7, 0.9, 2.7);
    Corners one, other;
    const int countOne = clipTriangle({{a, b, left}}, 1, 3, 3, one),
              countOther = clipTriangle({{b, a, right}}, 1, 3, 3, other);
    int shared = 0;
    for (int i = 0; i < countOne; ++i)
        for (int k = 0; k < countOther; ++k) shared += one[std::size_t(i)] == other[std::size_t(k)];
    EXPECT_EQ(shared, 2);  // b, and the cut of a b.
}

}  // namespace
}  // namespace aeolic::cpu
