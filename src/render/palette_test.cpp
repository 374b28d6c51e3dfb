#include "render/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "color_testing.h"
#include "description/colormap.h"
#include "render/shading_model.h"

/// The streaks' colours: what one reads off a small area is the colour map's own colour.
namespace aeolic {
namespace {

using namespace testkit;

/// What an area of even tone shows on average.
Triple meanOf(const StreakColors& streaks)
{
    const double knee = (streaks.base >> 24) / double(shading::kKneeZero) - 1;
    const Triple base = rgbOf(streaks.base), dark = rgbOf(streaks.dark), bright = rgbOf(streaks.bright);
    Triple mean{};
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] = base[c] + ((1 - knee) * (bright[c] - base[c]) + (1 + knee) * (dark[c] - base[c])) / 4;
    return mean;
}

TEST(Palette, TheDifferenceOfColoursIsThatOfItsAuthors)
{
    EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
    EXPECT_NEAR(ciede2000({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 1e-4);
    EXPECT_NEAR(ciede2000({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}), 0.9082, 1e-4);
}

TEST(Palette, StreaksHaveTheMapsOwnColourForTheirMean)
{
    for (const std::string_view name : colorMapNames())
        for (const double blend : {0.5, 0.8, 1.0}) {
            const double usual = blend > 0.8 ? 3 : 2, most = blend > 0.8 ? 5 : 4;
            int beyond = 0;
            for (const auto& color : colorMap(name)) {
                const StreakColors streaks = streakColors(color, blend);
                const double off = ciede2000(labOf(meanOf(streaks)), labOf(rgbOf(streaks.base)));
                EXPECT_LE(off, most) << name << ", blend " << blend;
                beyond += off > usual;
            }
            EXPECT_LE(beyond, 256 / 2) << name << ", blend " << blend;
        }
}

TEST(Palette, StreaksCanBeSeenOnEveryColour)
{
    for (const std::string_view name : colorMapNames())
        for (const auto& color : colorMap(name)) {
            const StreakColors streaks = streakColors(color, 0.8);
            EXPECT_GE(labOf(rgbOf(streaks.bright))[0] - labOf(rgbOf(streaks.dark))[0], 9)
                << name << ' ' << int(color[0]) << ' ' << int(color[1]) << ' ' << int(color[2]);
        }
}

TEST(Palette, StreaksKeepTheHue)
{
    for (const std::string_view name : colorMapNames())
        for (const auto& color : colorMap(name)) {
            const StreakColors streaks = streakColors(color, 0.8);
            const Triple base = labOf(rgbOf(streaks.base));
            if (std::hypot(base[1], base[2]) < 20) continue;  // Grays have none.
            for (const std::uint32_t end : {streaks.dark, streaks.bright}) {
                const Triple lab = labOf(rgbOf(end));
                if (std::hypot(lab[1], lab[2]) < 10) continue;
                const double cosine =
                    (base[1] * lab[1] + base[2] * lab[2]) / std::hypot(base[1], base[2]) / std::hypot(lab[1], lab[2]);
                EXPECT_GE(cosine, std::cos(0.6))  // Lines of equal hue of Oklab are not those of CIELAB, least in blue.
                    << name << ' ' << int(color[0]) << ' ' << int(color[1]) << ' ' << int(color[2]);
            }
        }
}

TEST(Palette, WithoutBlendThereAreNoStreaks)
{
    const StreakColors streaks = streakColors({10, 200, 90}, 0);
    EXPECT_EQ(streaks.base & 0xFFFFFFu, streaks.dark);
    EXPECT_EQ(streaks.base & 0xFFFFFFu, streaks.bright);
}

Color baseOf(const Palette& palette, std::size_t entry)
{
    const std::uint32_t word = palette.base[entry];
    return {std::uint8_t(word), std::uint8_t(word >> 8), std::uint8_t(word >> 16)};
}

TEST(Palette, ColoursBeyondTheRangeAreTheMapsEndsUnlessTheyAreChosen)
{
    ShadingOptions shading;
    Palette palette = makePalette(shading, true, {0, 1});
    EXPECT_EQ(baseOf(palette, Palette::kBelow), colorMap("viridis").front());
    EXPECT_EQ(baseOf(palette, Palette::kAbove), colorMap("viridis").back());
    EXPECT_EQ(baseOf(palette, Palette::kMasked), shading::kMaskedColor);
    ColorMap file{colorMap("viridis"), Color{1, 2, 3}, Color{4, 5, 6}, Color{7, 8, 9}};
    palette = makePalette(shading, true, {0, 1}, file);
    EXPECT_EQ(baseOf(palette, Palette::kMasked), (Color{1, 2, 3}));
    EXPECT_EQ(baseOf(palette, Palette::kBelow), (Color{4, 5, 6}));
    EXPECT_EQ(baseOf(palette, Palette::kAbove), (Color{7, 8, 9}));
    shading.nanColor = "0a0B0c";
    shading.belowColor = "0d0e0f";
    shading.aboveColor = "101112";
    palette = makePalette(shading, true, {0, 1}, file);
    EXPECT_EQ(baseOf(palette, Palette::kMasked), (Color{10, 11, 12}));
    EXPECT_EQ(baseOf(palette, Palette::kBelow), (Color{13, 14, 15}));
    EXPECT_EQ(baseOf(palette, Palette::kAbove), (Color{16, 17, 18}));
}

/// Interpolated values may be a rounding beyond the data's own ends, and then are not beyond the range.
TEST(Palette, TheDatasOwnEndsAreWithinTheRange)
{
    ShadingOptions shading;
    const Palette own = makePalette(shading, true, {1, 1});
    EXPECT_LT(own.lowest, std::nextafter(1.0f, 0.0f));
    EXPECT_GT(own.highest, std::nextafter(1.0f, 2.0f));
    shading.colorRange = {{1, 2}};
    const Palette given = makePalette(shading, true, {0, 9});
    EXPECT_EQ(given.lowest, 1.0f);
    EXPECT_EQ(given.highest, 2.0f);
}

TEST(Palette, TheWidestAndNarrowestRangesAreFinite)
{
    for (const auto& range : {std::array{-1e37, 1e37}, {0.0, 1e-320}, {-1e-300, 1e-300}, {0.0, 1e-44}}) {
        ShadingOptions shading;
        shading.colorRange = range;
        const Palette palette = makePalette(shading, true, {0, 1});
        EXPECT_GT(palette.entriesPerScalar, 0) << range[1];
        const float lowest = (float(range[0]) - palette.scalarLo) * palette.entriesPerScalar,
                    highest = (float(range[1]) - palette.scalarLo) * palette.entriesPerScalar;
        EXPECT_EQ(lowest, 0) << range[1];
        EXPECT_TRUE(highest >= 0 && std::isfinite(highest)) << range[1] << " " << highest;
    }
}

TEST(Palette, BandsAreEqualPartsFromTheMapsOneEndToTheOther)
{
    ShadingOptions shading;
    shading.colorScale = "bands:5";
    const Palette palette = makePalette(shading, true, {10, 20});
    EXPECT_EQ(palette.lastEntry, 4.0f);
    EXPECT_EQ(palette.entriesPerScalar, 0.5f);
    EXPECT_EQ(baseOf(palette, 0), colorMap("viridis").front());
    EXPECT_EQ(baseOf(palette, 2), colorMap("viridis")[128]);
    EXPECT_EQ(baseOf(palette, 4), colorMap("viridis").back());
}

TEST(Palette, LogarithmicEdgesAscendFromTheLowEnd)
{
    ShadingOptions shading;
    shading.colorScale = "log";
    const Palette palette = makePalette(shading, true, {1e-3, 1e5});
    ASSERT_TRUE(palette.searched);
    EXPECT_EQ(palette.edges[0], 1e-3f);
    EXPECT_NEAR(palette.edges[128], 10, 1e-4);
    for (std::size_t i = 1; i < palette.edges.size(); ++i) EXPECT_LT(palette.edges[i - 1], palette.edges[i]);
    EXPECT_FALSE(makePalette(shading, true, {5, 5}).searched) << "one value has no scale";
}

/// They have no logarithm, and get the colours that they have on a linear scale.
TEST(Palette, ALogarithmicScaleOfDataNowhereAboveZeroIsLinear)
{
    ShadingOptions linear, logarithmic;
    logarithmic.colorScale = "log";
    for (const std::array<double, 2>& range : {std::array{-7.0, -1.0}, {-7.0, 0.0}}) {
        const Palette a = makePalette(linear, true, range), b = makePalette(logarithmic, true, range);
        EXPECT_FALSE(b.searched);
        EXPECT_EQ(b.scalarLo, a.scalarLo);
        EXPECT_EQ(b.scalarHi, a.scalarHi);
        EXPECT_EQ(b.entriesPerScalar, a.entriesPerScalar);
        EXPECT_EQ(b.base, a.base);
    }
}

}  // namespace
}  // namespace aeolic
