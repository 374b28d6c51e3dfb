#include "render/gl/project/gl_resolve.h"

#include <cstring>

#include "render/gbuffer.h"
#include "render/gl/device/arguments.h"
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

void BrickResolve::start(Programs& programs, const GpuScene& scene, const FrameImages& images, bool withMask,
                         FieldPixels& out)
{
    const Extent& area = out.drawn;
    const bool withScalar = scene.scene().scalarFromField();
    out.flow.resize(area);
    if (withScalar) out.scalar.resize(area);
    if (withMask) out.masked.resize(area);
    if (area.empty()) return;
    const std::size_t bytes = std::size_t(area.width()) * std::size_t(area.height()) * 4;
    flow_.reserve(bytes);
    scalar_.reserve(withScalar ? bytes : 4);
    mask_.reserve(withMask ? bytes : 4);
    scene.bindMesh();
    scene.bindFields();
    images.visible.bind(0);
    bindStorage(4, flow_.get());
    bindStorage(5, scalar_.get());
    bindStorage(6, mask_.get());
    dispatchOver(resolveProgram(programs, scene.scene(), true), area, kGroupWidth);
    const auto copy = [&](ReadBack& copied, const GrowingBuffer& from) {
        copied.copy(from.get(), bytes);
        copied.start();
    };
    copy(flowCopy_, flow_);
    if (withScalar) copy(scalarCopy_, scalar_);
    if (withMask) copy(maskCopy_, mask_);
}

void BrickResolve::finish(FieldPixels& out)
{
    const Extent& area = out.drawn;
    const std::size_t rowBytes = std::size_t(area.width()) * 4;
    const auto take = [&](ReadBack& copied, auto& image) {
        if (!copied.pending()) return;  // There is none, or nothing in it.
        const std::byte* from = copied.wait();
        for (int y = area.y0; y < area.y1; ++y)
            std::memcpy(&image.at(area.x0, y), from + std::size_t(y - area.y0) * rowBytes, rowBytes);
    };
    take(flowCopy_, out.flow);
    take(scalarCopy_, out.scalar);
    take(maskCopy_, out.masked);
}

void maskLight(Programs& programs, const FrameImages& images, const Texture& masked, int y0, int y1)
{
    const GLuint program = programs.compute("mask_light");
    masked.bind(0);
    images.surface.bindImage(0);
    dispatchOver(program, {0, y0 - images.valid.y0, images.surface.width(), y1 - images.valid.y0}, kGroupWidth);
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
