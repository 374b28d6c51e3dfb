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

}  // namespace
}  // namespace aeolic
