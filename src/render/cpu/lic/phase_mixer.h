#pragma once

#include <array>

#include "render/gbuffer.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/phase_mix.h"

namespace aeolic::cpu {

/// The values of the phases of a cycle. Memory: three floats a pixel, from the first phase kept on.
class PhaseMixer {
public:
    /// Takes the values, and gives back an image of the same extent with any content.
    void keep(int which, LicImage& values);

    /// What Backend::mixPhases() does. Parallel; as fast as memory.
    void mix(const GBuffer& buffer, const std::array<float, phase_mix::kPhases>& weights, LicImage& values) const;

private:
    std::array<LicImage, phase_mix::kPhases> kept_;
};

}  // namespace aeolic::cpu
