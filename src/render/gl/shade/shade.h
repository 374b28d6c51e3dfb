#pragma once

#include "render/gl/device/frames_in_flight.h"
#include "render/gl/device/programs.h"
#include "render/gl/project/frame_images.h"
#include "render/palette.h"

namespace aeolic::gl {

/// Blending stage.
class Shade {
public:
    /// Draws rows `compute` (global) and starts their way off the GPU, to `out`; returns at once. frame.finish() waits
    /// for them.
    void start(Programs& programs, const FrameImages& images, const Palette& palette, bool hasLic,
               const Extent& compute, Tile& out, FrameInFlight& frame);

private:
    Buffer block_;
    GrowingBuffer pixels_{0};
};

}  // namespace aeolic::gl
