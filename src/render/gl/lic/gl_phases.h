#pragma once

#include <array>

#include "render/gl/device/programs.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/frame_images.h"
#include "render/lic/phase_mix.h"

namespace aeolic::gl {

/// The values of the phases of a cycle, on the device: three textures as large as that of the LIC stage's values, from
/// the first phase kept on.
class GlPhases {
public:
    void keep(int which, const FrameImages& images);

    /// What Backend::mixPhases() does, over all rows that are held.
    void mix(Programs& programs, const FrameImages& images, const std::array<float, phase_mix::kPhases>& weights,
             StageTimers& timers) const;

private:
    std::array<Texture, phase_mix::kPhases> kept_;
};

}  // namespace aeolic::gl
