#pragma once

#include "render/gl/device/beside_rows.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/frame_images.h"
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

}  // namespace aeolic::gl
