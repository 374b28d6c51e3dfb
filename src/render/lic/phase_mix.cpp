#include "render/lic/phase_mix.h"

namespace aeolic::phase_mix {

Mixture mixtureOf(const LicOptions& lic)
{
    if (lic.style == Style::oriented) return Turned{float(std::cos(lic.phase)), float(std::sin(lic.phase))};
    return weights(lic.phase);
}

std::span<const Run> runsOf(const LicOptions& lic)
{
    constexpr double quarter = std::numbers::pi / 2;
    static const std::array<Run, kPhases> dense{Run{GrainValue::none, phaseOf(0)}, Run{GrainValue::none, phaseOf(1)},
                                                Run{GrainValue::none, phaseOf(2)}};
    static constexpr std::array<Run, 4> oriented{Run{GrainValue::cosine, 0}, Run{GrainValue::cosine, quarter},
                                                 Run{GrainValue::sine, 0}, Run{GrainValue::sine, quarter}};
    static_assert(dense.size() <= kMostRuns && oriented.size() <= kMostRuns);
    if (lic.style == Style::oriented) return oriented;
    return dense;
}

}  // namespace aeolic::phase_mix
