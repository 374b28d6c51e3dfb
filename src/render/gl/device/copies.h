#pragma once

#include "render/gbuffer.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/read_back.h"
#include "render/gl/project/frame_images.h"
#include "render/guard_exchange.h"
#include "render/lic/row_flow.h"
#include "render/surface_overlay.h"

/// What leaves the GPU besides finished pixels. Each waits for the device.
namespace aeolic::gl {

/// The G-buffer of all rows held, for tests and tools.
void copySeen(const FrameImages& images, const Extent& rows, SeenSurface& out);

void copyGBuffer(const FrameImages& images, bool withScalar, GBuffer& out);

/// Flow and, unless it is null, scalar of all rows held, which both images span.
void copyFlow(const FrameImages& images, Image<std::uint32_t>& flow, Image<float>* scalar);

/// The LIC of rows `compute` (global); 0 where there is no flow, or no LIC at all.
void copyLic(const FrameImages& images, bool hasLic, const Extent& compute, Image<float>& out);

/// Replaces it.
void setLic(const FrameImages& images, const Image<float>& values);

/// Writes rows [y0, y1) (global) of `image` to `texture`. The image's extent is that of the rows held.
void upload(const Texture& texture, ImageRows rows, int y0, int y1);

/// Facts of rows [y0, y1), global.
class RowFlowCopy {
public:
    std::vector<RowFlow> get(Programs& programs, const FrameImages& images, int y0, int y1);

private:
    GrowingBuffer facts_{0};
    ReadBack copy_;
};

}  // namespace aeolic::gl
