#pragma once

#include "aeolic/scene_description.h"
#include "render/gl/device/beside_rows.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/frame_images.h"

namespace aeolic::gl {

/// The last step of even streaks (render/flatten.h).
class Flatten {
public:
    /// What Backend::flatten() does, rows global. `height`: the picture's.
    void run(Programs& programs, const FrameImages& images, const LicOptions& lic, int height, const Extent& compute,
             RowExchange* beside, int more, StageTimers& timers);

private:
    BesideRows words_;
    GrowingBuffer sums_{0};
};

}  // namespace aeolic::gl
