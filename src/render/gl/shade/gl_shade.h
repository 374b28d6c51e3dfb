#pragma once

#include "render/gl/device/frames_in_flight.h"
#include "render/gl/device/programs.h"
#include "render/gl/project/frame_images.h"
#include "render/palette.h"

namespace aeolic::gl {

/// Blending stage.
class Shade {
public:
    /// Draws rows `shown` (global) into pixels(). The palette's block and tables stay bound.
    /// `open`: of the same rows, as Occlusion leaves it; read where the palette has occlusion.
    void draw(Programs& programs, const FrameImages& images, const Palette& palette, bool hasLic, const Extent& shown,
              const Buffer& open);
    /// RGBA bytes, row after row.
    const Buffer& pixels() const { return pixels_.get(); }
    /// Starts the way of rows `compute`, which are among those drawn, off the GPU, to `out`; returns at once.
    /// frame.finish() waits for them.
    void send(const Extent& compute, Tile& out, FrameInFlight& frame) const;

private:
    Extent shown_;
    Buffer block_;
    GrowingBuffer tables_{GL_DYNAMIC_STORAGE_BIT};
    GrowingBuffer pixels_{0};
};

}  // namespace aeolic::gl
