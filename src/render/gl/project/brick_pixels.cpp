#include "render/gl/project/brick_pixels.h"

#include <algorithm>
#include <limits>

#include "render/gl/device/copies.h"

namespace aeolic::gl {

void BrickPixels::start(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& drawn,
                        bool withMask)
{
    withMask_ = withMask;
    pixels_.drawn = drawn;
    resolve_.start(programs, scene, images, withMask, pixels_);
}

const FieldPixels& BrickPixels::finish()
{
    resolve_.finish(pixels_);
    return pixels_;
}

FieldRows BrickPixels::rows(const FrameImages& images, bool withScalar, bool mixed)
{
    const Extent& valid = images.valid;
    withScalar_ = withScalar;
    flow_.resize(valid);
    if (withScalar) scalar_.resize(valid);
    if (withMask_) masked_.resize(valid);
    for (int y = valid.y0; y < valid.y1; ++y) {
        std::fill_n(&flow_.at(valid.x0, y), valid.width(), 0u);
        if (withScalar) std::fill_n(&scalar_.at(valid.x0, y), valid.width(), std::numeric_limits<float>::quiet_NaN());
        if (withMask_) std::fill_n(&masked_.at(valid.x0, y), valid.width(), 0u);
    }
    if (mixed) copyFlow(images, flow_, withScalar ? &scalar_ : nullptr);
    return {&flow_, withScalar ? &scalar_ : nullptr, withMask_ ? &masked_ : nullptr};
}

void BrickPixels::upload(Programs& programs, const FrameImages& images, int y0, int y1)
{
    gl::upload(images.flow, imageRows(flow_), y0, y1);
    if (withScalar_) gl::upload(images.scalar, imageRows(scalar_), y0, y1);
    if (!withMask_) return;
    const int width = images.flow.width(), height = images.flow.height();
    if (!mask_ || mask_.width() != width || mask_.height() != height) {
        mask_ = {};
        mask_ = Texture::image(GL_R32UI, width, height);
    }
    gl::upload(mask_, imageRows(masked_), y0, y1);
    maskLight(programs, images, mask_, y0, y1);
}

}  // namespace aeolic::gl
