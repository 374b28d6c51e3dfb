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

/// The field's part alone, of the pixels that lie in this rank's brick.
class BrickResolve {
public:
    /// Makes `out` as large as `out.drawn`, and has it filled; its mask only `withMask`.
    void start(Programs& programs, const GpuScene& scene, const FrameImages& images, bool withMask, FieldPixels& out);
    /// Waits for the device: `out`, which was started, is filled.
    void finish(FieldPixels& out);

private:
    GrowingBuffer flow_{0}, scalar_{0}, mask_{0};
    ReadBack flowCopy_, scalarCopy_, maskCopy_;
};

/// Gives the light of the pixels that `masked` marks its sign, in rows [y0, y1), global. `masked` holds the same rows
/// as the images.
void maskLight(Programs& programs, const FrameImages& images, const Texture& masked, int y0, int y1);

/// Which of a pixel's neighbours lie on its own sheet, for rows [y0, y1) of those held; runs near flow.
class NearTiles;
void linkSheets(Programs& programs, const NearTiles& near, const FrameImages& images, float focalPx, int y0, int y1);

}  // namespace aeolic::gl
