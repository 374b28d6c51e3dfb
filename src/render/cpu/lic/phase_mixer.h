#pragma once

#include <array>

#include "render/gbuffer.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/phase_mix.h"

namespace aeolic::cpu {

/// The values that a cycle of phases is mixed from. Memory: a float a pixel for each that is kept, from the first on.
class PhaseMixer {
public:
    /// Takes the values, and gives back an image of the same extent with any content.
    void keep(int which, LicImage& values);

    /// What Backend::mixPhases() does. Parallel; as fast as memory.
    void mix(const GBuffer& buffer, const phase_mix::Mixture& mixture, LicImage& values) const;

private:
    std::array<LicImage, phase_mix::kMostKept> kept_;
};

}  // namespace aeolic::cpu
