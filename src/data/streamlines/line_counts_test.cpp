#include "data/streamlines/line_counts.h"

#include <gtest/gtest.h>

#include "base/mixed_bits.h"

namespace aeolic {
namespace {

double part(std::uint64_t which)
{
    return double(mixedBits(which) >> 11) * 0x1p-53;
}

TEST(LineCounts, AreThoseWithinTheReach)
{
    std::vector<LineSample> samples;
    for (std::uint64_t i = 0; i < 4000; ++i)
        samples.push_back({glm::vec3(part(4 * i) - 0.5, part(4 * i + 1) - 0.5, 0.3 * part(4 * i + 2)),
                           {0, 0, part(4 * i + 3) < 0.5 ? 1 : -1},
                           std::uint32_t(i),
                           0});
    const LineCounts counts(samples, 0.07f);
    for (std::uint64_t i = 0; i < 300; ++i) {
        LineSample place = samples[i];
        place.at += glm::vec3(0.1f * float(i % 5));
        std::size_t expected = 0;
        for (const LineSample& sample : samples) {
            const glm::vec3 way = sample.at - place.at;
            expected += glm::dot(way, way) < 0.07f * 0.07f && sample.normal.z == place.normal.z;
        }
        EXPECT_EQ(counts.near(place), expected) << i;
        EXPECT_GE(counts.atMost(place), expected) << i;
    }
}

TEST(LineCounts, OfNothingAreNone)
{
    const LineCounts counts({}, 1);
    EXPECT_EQ(counts.near({{0, 0, 0}, {0, 0, 1}, 0, 0}), 0u);
    EXPECT_EQ(counts.atMost({{1e30f, 0, -1e30f}, {0, 0, 1}, 0, 0}), 0u);
}

}  // namespace
}  // namespace aeolic
