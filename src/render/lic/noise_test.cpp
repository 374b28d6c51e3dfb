#include "render/lic/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/reference.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

int texel(const NoisePyramid& noise, int x, int y, int z, int corner = 0)
{
    constexpr int n = NoisePyramid::kSize;
    const auto wrap = [](int v) { return std::size_t((v % n + n) % n); };
    return noise.cells[NoisePyramid::index(wrap(x), wrap(y), wrap(z))] >> corner & 1;
}

TEST(Noise, EveryCellCarriesItsEightCornersAcrossTheTilesBorder)
{
    const NoisePyramid noise(1);
    for (const auto& [x, y, z] :
         {std::array{0, 0, 0}, std::array{63, 5, 9}, std::array{63, 63, 63}, std::array{10, 63, 0}})
        for (int c = 0; c < 8; ++c)
            EXPECT_EQ(texel(noise, x, y, z, c), texel(noise, x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))) << c;
}

/// There are as many black texels as white ones, within what chance does to 64^3 of them.
TEST(Noise, HalfOfTheTexelsAreWhite)
{
    for (const std::uint32_t seed : {0u, 1u, 2u, 0xFFFFFFFFu}) {
        const NoisePyramid noise(seed);
        int white = 0;
        for (int z = 0; z < 64; ++z)
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x) white += texel(noise, x, y, z);
        EXPECT_NEAR(white / std::pow(64.0, 3), 0.5, 0.004) << seed;
    }
}

TEST(Noise, NeighbouringTexelsAreIndependent)
{
    const NoisePyramid noise(7);
    for (const auto& [dx, dy, dz] : {std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{0, 0, 1}, std::array{1, 1, 0},
                                     std::array{1, 1, 1}, std::array{2, 0, 0}}) {
        std::vector<double> a, b;
        for (int z = 0; z < 64; z += 3)
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x) {
                    a.push_back(texel(noise, x, y, z));
                    b.push_back(texel(noise, x + dx, y + dy, z + dz));
                }
        EXPECT_LT(std::abs(correlation(a, b)), 0.015) << dx << dy << dz;
    }
}

TEST(Noise, SeedsDecideEverythingAndNothingElseDoes)
{
    EXPECT_EQ(NoisePyramid(5).cells, NoisePyramid(5).cells);
    EXPECT_NE(NoisePyramid(5).cells, NoisePyramid(6).cells);
    std::vector<double> a, b;
    const NoisePyramid first(5), second(6);
    for (int i = 0; i < 64 * 64 * 64; ++i) {
        a.push_back(texel(first, i, i / 64, i / 4096));
        b.push_back(texel(second, i, i / 64, i / 4096));
    }
    EXPECT_LT(std::abs(correlation(a, b)), 0.01);
}

std::vector<double> alongALine(const NoisePyramid& noise, const NoiseLookup& lookup, double footprint, double spacing,
                               int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(
            reference::noiseAt(noise, lookup, {spacing * i, 0.37 * spacing * i, -0.71 * spacing * i}, footprint));
    return values;
}

void expectNoSeams(const NoisePyramid& noise, const NoiseLookup& lookup)
{
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 at(0.013 * i, 0.4 - 0.007 * i, 0.02 * i);
        double before = reference::noiseAt(noise, lookup, at, 0.001);
        for (double footprint = 0.001; footprint < 0.01; footprint *= 1.002) {
            const double now = reference::noiseAt(noise, lookup, at, footprint);
            EXPECT_LT(std::abs(now - before), 0.02) << footprint;
            before = now;
        }
    }
}

/// Whatever the distance of the surface, the noise has the contrast that the gain of the LIC counts on.
TEST(Noise, ContrastIsTheSameAtEveryFootprint)
{
    const NoisePyramid noise(1);
    const NoiseLookup lookup = makeNoiseLookup(1, 1);
    for (double footprint = 1e-4; footprint < 1; footprint *= 1.31) {
        const std::vector<double> values = alongALine(noise, lookup, footprint, 1.7 * footprint, 20000);
        EXPECT_NEAR(standardDeviation(values), kNoiseSigma, 0.02) << footprint;
        EXPECT_NEAR(mean(values), 0, 0.02) << footprint;
    }
}

/// From level to level the pattern changes without a jump: a zoom does not pop.
TEST(Noise, LevelsBlendWithoutASeam)
{
    const NoisePyramid noise(1);
    const NoiseLookup lookup = makeNoiseLookup(1, 1);
    expectNoSeams(noise, lookup);
}

/// A finer noise has its texels closer together by the same factor.
TEST(Noise, ScaleDividesTheGrain)
{
    const NoisePyramid noise(1);
    const NoiseLookup one = makeNoiseLookup(1, 1), two = makeNoiseLookup(1, 2);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 at(0.013 * i, 0.4, 0.02 * i);
        EXPECT_NEAR(reference::noiseAt(noise, two, at, 0.02), reference::noiseAt(noise, one, at, 0.01), 1e-9);
    }
}

/// Grains lie evenly: as many as find room, and no two of them neighbours, across the tile's border, too.
TEST(Noise, GrainsLieApart)
{
    constexpr int n = NoisePyramid::kSize;
    for (const std::uint32_t seed : {0u, 1u, 7u, 0xFFFFFFFFu}) {
        const NoisePyramid noise(seed, Style::oriented);
        int found = 0, tooNear = 0, rooms = 0;
        for (int z = 0; z < n; ++z)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    int near = 0;
                    for (int dz = -2; dz <= 2; ++dz)
                        for (int dy = -2; dy <= 2; ++dy)
                            for (int dx = -2; dx <= 2; ++dx)
                                if (dx * dx + dy * dy + dz * dz < grains::kApart2)
                                    near += texel(noise, x + dx, y + dy, z + dz);
                    const int here = texel(noise, x, y, z);
                    found += here;
                    tooNear += here && near > 1;
                    rooms += near == 0;
                }
        EXPECT_EQ(tooNear, 0) << seed;
        EXPECT_EQ(rooms, 0) << seed;
        EXPECT_NEAR(found / std::pow(double(n), 3), double(grains::kShare), 0.01 * double(grains::kShare)) << seed;
    }
    EXPECT_NE(NoisePyramid(5, Style::oriented).cells, NoisePyramid(6, Style::oriented).cells);
}

/// Their mean is taken off, at any distance, so no patch is lighter than another; and a zoom does not pop.
TEST(Noise, GrainsHaveNoMeanAndBlendWithoutASeam)
{
    const NoisePyramid noise(1, Style::oriented);
    const NoiseLookup lookup = makeNoiseLookup(1, 1, Style::oriented);
    for (double footprint = 1e-4; footprint < 1; footprint *= 1.31) {
        const std::vector<double> values = alongALine(noise, lookup, footprint, 1.7 * footprint, 20000);
        EXPECT_NEAR(mean(values), 0, 0.003) << footprint;
        EXPECT_NEAR(standardDeviation(values), 0.045, 0.015) << footprint;
    }
    expectNoSeams(noise, lookup);
}

/// The tile lies askew: a flat wall along the axes does not meet the same texels again.
TEST(Noise, AxisAlignedPlanesDoNotRepeat)
{
    const NoisePyramid noise(1);
    const NoiseLookup lookup = makeNoiseLookup(1024, 1);  // Level 0 has unit texels.
    const auto row = [&](double x, double y) {
        std::vector<double> values;
        for (int i = 0; i < 400; ++i) values.push_back(reference::noiseAt(noise, lookup, {x + 0.9 * i, y, 0}, 1));
        return values;
    };
    const std::vector<double> first = row(0, 0);
    for (const double period : {32.0, 64.0, 128.0}) {
        EXPECT_LT(std::abs(correlation(first, row(period, 0))), 0.25) << period;
        EXPECT_LT(std::abs(correlation(first, row(0, period))), 0.25) << period;
        EXPECT_LT(std::abs(correlation(first, row(period, period))), 0.25) << period;
    }
}

}  // namespace
}  // namespace aeolic
