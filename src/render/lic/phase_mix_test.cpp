#include "render/lic/phase_mix.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(PhaseMix, ThePhasesThatAreKeptAreThemselves)
{
    for (int which = 0; which < phase_mix::kPhases; ++which) {
        const auto weights = phase_mix::weights(phase_mix::phaseOf(which));
        for (int i = 0; i < phase_mix::kPhases; ++i)
            EXPECT_NEAR(weights[std::size_t(i)], i == which ? 1 : 0, 1e-7) << which << ", " << i;
    }
}

TEST(PhaseMix, AWaveOfOneTurnIsMixedExactly)
{
    const auto wave = [](double phase) { return 0.3 + 0.8 * std::cos(phase) - 0.6 * std::sin(phase); };
    for (double phase = -7; phase < 7; phase += 0.37) {
        const auto weights = phase_mix::weights(phase);
        double mixed = 0, all = 0;
        for (int i = 0; i < phase_mix::kPhases; ++i) {
            mixed += double(weights[std::size_t(i)]) * wave(phase_mix::phaseOf(i));
            all += double(weights[std::size_t(i)]);
        }
        EXPECT_NEAR(mixed, wave(phase), 1e-6);
        EXPECT_NEAR(all, 1, 1e-6);
    }
}

TEST(PhaseMix, OrientedStreaksHaveFourRuns)
{
    LicOptions lic;
    EXPECT_EQ(phase_mix::runsOf(lic).size(), 3U);
    lic.style = Style::oriented;
    lic.phase = 1;
    ASSERT_EQ(phase_mix::runsOf(lic).size(), 4U);
    const auto turned = std::get<phase_mix::Turned>(phase_mix::mixtureOf(lic));
    EXPECT_FLOAT_EQ(turned.cosine, float(std::cos(1.0)));
    EXPECT_FLOAT_EQ(turned.sine, float(std::sin(1.0)));
}

/// It grows for most of the turn up to its head, and falls at half a turn. Nowhere is it darker than nothing.
TEST(PhaseMix, ACometHasItsHeadAtHalfATurn)
{
    using phase_mix::Comet;
    const auto comet = [](double degrees) {
        double sum = double(Comet::kMean / Comet::kContrast);
        for (int k = 1; k <= 3; ++k) {
            const double angle = k * degrees * std::numbers::pi / 180;
            sum += double(Comet::kCosine[std::size_t(k - 1)]) * std::cos(angle) +
                   double(Comet::kSine[std::size_t(k - 1)]) * std::sin(angle);
        }
        return sum;
    };
    double most = 0, head = 0;
    for (int degrees = -180; degrees < 180; ++degrees) {
        EXPECT_GT(comet(degrees), -0.03) << degrees;
        if (comet(degrees) > most) most = comet(degrees), head = degrees;
        if (degrees > -100 && degrees < 120) {
            EXPECT_GT(comet(degrees + 1), comet(degrees)) << degrees;
        }
    }
    EXPECT_GT(head, 120);
    EXPECT_LT(head, 160);
    EXPECT_NEAR(most, 0.75, 0.1);
    EXPECT_LT(comet(200), 0.4 * most);
}

/// Grains have phases of their own, evenly.
TEST(PhaseMix, PhasesOfGrainsAreSpread)
{
    int count[grains::kPhases] = {};
    for (std::uint32_t texel = 0; texel < 1u << 18; ++texel) ++count[grains::phaseOf(texel)];
    for (const int of : count) EXPECT_NEAR(of, (1 << 18) / grains::kPhases, 600);
    for (int k = 0; k < grains::kPhases; ++k)
        EXPECT_NEAR(double(grains::kWave[std::size_t(k)]), std::cos(2 * std::numbers::pi * k / grains::kPhases), 1e-7);
}

}  // namespace
}  // namespace aeolic
