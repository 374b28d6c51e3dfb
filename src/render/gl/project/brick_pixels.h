#pragma once

#include "render/gl/project/gl_resolve.h"

namespace aeolic::gl {

/// Where the field is split into bricks: this rank's pixels on their way to all ranks, and all bricks' pixels of this
/// rank's rows on their way back to the device.
class BrickPixels {
public:
    /// Has the visible pixels of `drawn` found that lie in this rank's brick. `withMask`: also where no streaks show.
    void start(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& drawn,
               bool withMask);
    /// Those. Waits for the device, and with it for what it still has to do of the frame before: other ranks wait for
    /// them too.
    const FieldPixels& finish();

    /// The rows held, to be filled by others. `mixed`: with what surfaces carry, for which this waits for the device;
    /// else with nothing in them yet.
    FieldRows rows(const FrameImages& images, bool withScalar, bool mixed);

    /// Rows [y0, y1) (global) of those, to the device.
    void upload(Programs& programs, const FrameImages& images, int y0, int y1);

private:
    BrickResolve resolve_;
    FieldPixels pixels_;
    Image<std::uint32_t> flow_;
    Image<float> scalar_;
    Image<std::uint32_t> masked_;
    Texture mask_;  // The same on the device.
    bool withScalar_ = false, withMask_ = false;
};

}  // namespace aeolic::gl
