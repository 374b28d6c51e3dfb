#pragma once

#include "render/gl/project/resolve.h"

namespace aeolic::gl {

/// Where the field is split into bricks: this rank's pixels on their way to all ranks, and all bricks' pixels of this
/// rank's rows on their way back to the device.
class BrickPixels {
public:
    /// Has the visible pixels of `drawn` found that lie in this rank's brick.
    void start(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& drawn);
    /// Those. Waits for the device, and with it for what it still has to do of the frame before: other ranks wait for
    /// them too.
    const FieldPixels& finish();

    /// Rows of `valid` with nothing in them yet, to be filled by others.
    FieldRows rows(const Extent& valid, bool withScalar);

    /// Rows [y0, y1) (global) of those, to the device.
    void upload(const FrameImages& images, int y0, int y1);

private:
    BrickResolve resolve_;
    FieldPixels pixels_;
    Image<std::uint32_t> flow_;
    Image<float> scalar_;
    bool withScalar_ = false;
};

}  // namespace aeolic::gl
