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
            const double usual = blend > 0.8 ? 3 : 2;
            int beyond = 0;
            for (const auto& color : colorMap(name)) {
                const StreakColors streaks = streakColors(color, blend);
                const double off = ciede2000(labOf(meanOf(streaks)), labOf(rgbOf(streaks.base)));
                EXPECT_LE(off, 4) << name << ", blend " << blend;
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
                EXPECT_GE(cosine, std::cos(0.5))
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

}  // namespace
}  // namespace aeolic
