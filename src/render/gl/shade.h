#pragma once

#include "render/gl/frame_images.h"
#include "render/gl/programs.h"
#include "render/gl/stage_timers.h"
#include "render/palette.h"
#include "render/tile.h"

namespace aeolic::gl {

/// Blending stage, and the way of its pixels off the GPU.
class Shade {
public:
    Shade() = default;
    ~Shade();

    /// Draws rows `compute` (global) and starts copying them to where the processor sees them; returns at once.
    void start(Programs& programs, const FrameImages& images, const Palette& palette, bool hasLic,
               const Extent& compute, StageTimers& timers);

    /// Waits for that and puts the pixels in their place in `out`.
    void finish(Tile& out);

private:
    Extent compute_;
    Buffer block_;
    GrowingBuffer pixels_{0};
    Buffer staging_;  // Mapped for good.
    const std::uint8_t* mapped_ = nullptr;
    GLsync copied_ = nullptr;
};

}  // namespace aeolic::gl
