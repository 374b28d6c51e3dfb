#pragma once

#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/read_back.h"
#include "render/gl/project/frame_images.h"
#include "render/share.h"

namespace aeolic::gl {

/// Projection stage, second part: the visible pixels of `area` (global) become the G-buffer's, but for links. Where the
/// field is split into bricks: without the field's values. The view block is bound.
void resolve(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& area);

/// Where the field is split into bricks: this rank's pixels on their way to all ranks, and all bricks' pixels of this
/// rank's rows on their way back to the device.
class BrickPixels {
public:
    /// Has the field's part found of those visible pixels of `drawn` that lie in this rank's brick. `withMask`: also
    /// where no streaks show.
    void start(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& drawn,
               bool withMask);
    /// The field's part of those pixels. Waits for the device, and with it for what it still has to do of the frame
    /// before: other ranks wait for these pixels, too.
    const FieldPixels& finish();

    /// The rows held, to be filled by others. `mixed`: with what surfaces carry, for which this waits for the device;
    /// else with nothing in them yet.
    FieldRows rows(const FrameImages& images, bool withScalar, bool mixed);

    /// Rows [y0, y1) (global) of those, to the device.
    void upload(Programs& programs, const FrameImages& images, int y0, int y1);

private:
    GrowingBuffer flowBuffer_{0}, scalarBuffer_{0}, maskBuffer_{0};
    ReadBack flowCopy_, scalarCopy_, maskCopy_;
    FieldPixels pixels_;
    Image<std::uint32_t> flow_;
    Image<float> scalar_;
    Image<std::uint32_t> masked_;
    Texture mask_;  // The same on the device.
    bool withScalar_ = false, withMask_ = false;
};

/// Which of a pixel's neighbours lie on its own sheet, for rows [y0, y1) of those held; runs near flow.
class NearTiles;
void linkSheets(Programs& programs, const NearTiles& near, const FrameImages& images, float focalPx, int y0, int y1);

}  // namespace aeolic::gl
