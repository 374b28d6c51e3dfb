#include "render/gl/project/gl_resolve.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "render/gbuffer.h"
#include "render/gl/device/copies.h"
#include "render/gl/device/dispatch.h"
#include "render/gl/lic/near_tiles.h"
#include "render/limits.h"

namespace aeolic::gl {
namespace {

constexpr int kGroupWidth = 8;  // Of the programs here.

GLuint resolveProgram(Programs& programs, const Scene& scene, bool brick)
{
    const SurfaceMesh& mesh = scene.surface;
    const bool field = brick || !scene.bricked(), mixed = scene.mixed();
    return programs.compute("resolve", {{"BRICK", brick},
                                        {"SAMPLED", field || mixed},
                                        {"MIXED", mixed},
                                        {"WITH_SCALAR", brick ? scene.scalarFromField() : scene.hasScalar},
                                        {"SEVERAL_SURFACES", !scene.surfaces.empty()},
                                        {"HAS_FIELD", field && scene.field},
                                        {"HAS_SCALAR_FIELD", field && scene.scalarField},
                                        {"SCALAR_IS_MAGNITUDE", field && scene.ofVectors == ArrayPart::length},
                                        {"SCALAR_IS_NORMAL", scene.ofVectors == ArrayPart::normal},
                                        {"SCALAR_IS_TANGENTIAL", scene.ofVectors == ArrayPart::tangential},
                                        {"CELL_VECTORS", !mesh.cellVectors.empty()},
                                        {"CELL_SCALARS", !mesh.cellScalars.empty()},
                                        {"POINT_SCALARS", !mesh.pointScalars.empty()}});
}

/// Gives the light of the pixels that `masked` marks its sign, in rows [y0, y1), global. `masked` holds the same rows
/// as the images.
void maskLight(Programs& programs, const FrameImages& images, const Texture& masked, int y0, int y1)
{
    const GLuint program = programs.compute("mask_light");
    masked.bind(0);
    images.surface.bindImage(0);
    dispatchOver(program, {0, y0 - images.valid.y0, images.surface.width(), y1 - images.valid.y0}, kGroupWidth);
}

}  // namespace

void resolve(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& area)
{
    if (area.empty()) return;
    scene.bindMesh();
    scene.bindFields();
    images.visible.bind(0);
    images.surface.bindImage(0);
    images.flow.bindImage(1);
    if (images.scalar) images.scalar.bindImage(2);
    if (images.colors) images.colors.bindImage(3);
    dispatchOver(resolveProgram(programs, scene.scene(), false), area, kGroupWidth);
}

void BrickPixels::start(Programs& programs, const GpuScene& scene, const FrameImages& images, const Extent& drawn,
                        bool withMask)
{
    const bool withScalar = scene.scene().scalarFromField();
    withMask_ = withMask;
    pixels_.drawn = drawn;
    pixels_.flow.resize(drawn);
    if (withScalar) pixels_.scalar.resize(drawn);
    if (withMask) pixels_.masked.resize(drawn);
    if (drawn.empty()) return;
    const std::size_t bytes = std::size_t(drawn.width()) * std::size_t(drawn.height()) * 4;
    flowBuffer_.reserve(bytes);
    scalarBuffer_.reserve(withScalar ? bytes : 4);
    maskBuffer_.reserve(withMask ? bytes : 4);
    scene.bindMesh();
    scene.bindFields();
    images.visible.bind(0);
    bindStorage(4, flowBuffer_.get());
    bindStorage(5, scalarBuffer_.get());
    bindStorage(6, maskBuffer_.get());
    dispatchOver(resolveProgram(programs, scene.scene(), true), drawn, kGroupWidth);
    const auto copy = [&](ReadBack& copied, const GrowingBuffer& from) {
        copied.copy(from.get(), bytes);
        copied.start();
    };
    copy(flowCopy_, flowBuffer_);
    if (withScalar) copy(scalarCopy_, scalarBuffer_);
    if (withMask) copy(maskCopy_, maskBuffer_);
}

const FieldPixels& BrickPixels::finish()
{
    const Extent& area = pixels_.drawn;
    const std::size_t rowBytes = std::size_t(area.width()) * 4;
    const auto take = [&](ReadBack& copied, auto& image) {
        if (!copied.pending()) return;  // There is none, or nothing in it.
        const std::byte* from = copied.wait();
        for (int y = area.y0; y < area.y1; ++y)
            std::memcpy(&image.at(area.x0, y), from + std::size_t(y - area.y0) * rowBytes, rowBytes);
    };
    take(flowCopy_, pixels_.flow);
    take(scalarCopy_, pixels_.scalar);
    take(maskCopy_, pixels_.masked);
    return pixels_;
}

FieldRows BrickPixels::rows(const FrameImages& images, bool withScalar, bool mixed)
{
    const Extent& valid = images.valid;
    withScalar_ = withScalar;
    const auto clear = [&](auto& image, auto value) {
        image.resize(valid);
        image.fill(valid, value);
    };
    clear(flow_, 0u);
    if (withScalar) clear(scalar_, std::numeric_limits<float>::quiet_NaN());
    if (withMask_) clear(masked_, 0u);
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

void linkSheets(Programs& programs, const NearTiles& near, const FrameImages& images, float focalPx, int y0, int y1)
{
    const GLuint program = programs.compute("links");
    setFloats(program, 1, 0.5f * limits::kSlackFootprints / focalPx);
    images.flow.bind(0);
    images.surface.bind(1);
    images.links.bindImage(0);
    near.run(program, y0, y1);
}

}  // namespace aeolic::gl
