#pragma once

#include "render/gl/device/beside_rows.h"
#include "render/gl/device/frames_in_flight.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/frame_images.h"
#include "render/palette.h"
#include "render/view.h"

namespace aeolic::gl {

/// Ambient occlusion (render/occlusion.h).
class Occlusion {
public:
    /// The view's block is bound.
    struct Pass {
        Programs& programs;
        const FrameImages& images;
        const View& view;
        StageTimers& timers;
    };

    /// Finds the open share in rows `compute` (global) and `more` rows on each side. Collective with `beside`, which
    /// brings other ranks' depths and hidden shares; Local without.
    void run(const Pass& pass, const Extent& compute, RowExchange* beside, int more);

    /// A float for each pixel of those rows, in full width.
    const Buffer& open() { return open_.reserve(sizeof(float)); }

private:
    void copyDepths(const Pass& pass, const Extent& compute, int rows);
    void findHidden(const Pass& pass, const Extent& compute, int radius, int rows);
    void findOpen(const Pass& pass, const Extent& area);

    BesideRows depths_, hidden_;
    GrowingBuffer open_{0};
};

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
