#pragma once

#include <array>

#include "render/gl/device/programs.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/frame_images.h"
#include "render/lic/phase_mix.h"

namespace aeolic::gl {

/// The values that a cycle of phases is mixed from, on the device: a texture for each that is kept, as large as that of
/// the LIC stage's values.
class GlPhases {
public:
    void keep(int which, const FrameImages& images);

    /// What Backend::mixPhases() does, over all rows that are held.
    void mix(Programs& programs, const FrameImages& images, const phase_mix::Mixture& mixture,
             StageTimers& timers) const;

private:
    std::array<Texture, phase_mix::kMostKept> kept_;
};

}  // namespace aeolic::gl
