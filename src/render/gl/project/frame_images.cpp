#include "render/gl/project/frame_images.h"

#include <algorithm>

#include "base/image.h"
#include "render/gl/device/draw_visibility.h"
#include "render/gl/device/gl_limits.h"

namespace aeolic::gl {
namespace {

constexpr int kRowsBeyond = Image<float>::kApronRows;
/// All below, with two levels of jumps, and what edges, means, occlusion and phases take (Edges, Flatten,
/// Occlusion, GlPhases).
constexpr std::uint64_t kBytesPerPixel = 222;

}  // namespace

void FrameImages::resize(int width, int height, const Extent& rows, bool withScalar, bool withColors)
{
    const bool sameImage = visible && visible.width() == width && visible.height() == height;
    const bool fits = sameImage && rows.height() <= rows_ && bool(scalar) == withScalar && bool(colors) == withColors;
    if (fits && rows.height() == valid.height()) {
        valid = rows;
        return;
    }
    valid = rows;
    if (fits) return clearBeyond();
    // A stripe that grows from frame to frame takes new memory only now and then.
    const int slack = rows.height() < height ? rows.height() / 8 + kRowsBeyond : 0;
    const std::uint64_t heldBytes = std::uint64_t(surface.width()) * std::uint64_t(surface.height()) * kBytesPerPixel;
    requireFrame(width, height, rows.height() + slack, kBytesPerPixel, heldBytes);
    if (!sameImage) {
        target = {};
        visible = {};
        depth = {};
        visible = Texture::image(GL_R32UI, width, height);
        depth = Texture::image(GL_DEPTH_COMPONENT32F, width, height);
        target = makeTarget(visible, depth);
    }
    rows_ = std::min(std::max(rows.height() + slack, 1), height);
    for (Texture* texture :
         {&surface, &flow, &links, &scalar, &colors, &openFlow, &wholeFlow, &lic, &words, &places, &metas, &weighted})
        *texture = {};  // Before new ones are taken: never both.
    surface = Texture::image(GL_RGBA32F, width, rows_);
    flow = Texture::image(GL_R32UI, width, rows_);
    links = Texture::image(GL_R8UI, width, rows_);
    if (withScalar) scalar = Texture::image(GL_R32F, width, rows_);
    if (withColors) colors = Texture::image(GL_R8UI, width, rows_);
    openFlow = Texture::image(GL_R32UI, width, rows_);
    wholeFlow = Texture::image(GL_R32UI, width, rows_);
    lic = Texture::image(GL_R32F, width, rows_);
    words = Texture::image(GL_R32UI, width, rows_);
}

void FrameImages::resizeJumps(int levels, bool withWeighted)
{
    const int layers = 2 * levels;
    const auto make = [&](Texture& texture) {
        if (texture && texture.depth() >= layers) return;
        texture = {};
        texture = Texture::layers(GL_R32UI, flow.width(), flow.height(), layers);
    };
    make(places);
    make(metas);
    if (withWeighted) make(weighted);
}

void FrameImages::bindColors(GLuint scalarUnit, GLuint colorsUnit) const
{
    (scalar ? scalar : surface).bind(scalarUnit);
    (colors ? colors : visible).bind(colorsUnit);
}

void FrameImages::clearBeyond() const
{
    const int y0 = valid.height(), y1 = std::min(y0 + kRowsBeyond, rows_);
    for (const Texture* texture : {&flow, &links, &openFlow, &wholeFlow, &places, &metas, &weighted})
        if (*texture) texture->clearRows(y0, y1);
}

}  // namespace aeolic::gl
