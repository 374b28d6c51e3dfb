#include "render/gl/shade/gl_shade.h"

#include <algorithm>
#include <array>

#include "render/gbuffer.h"
#include "render/gl/device/dispatch.h"
#include "render/gl/device/gl_blocks.h"
#include "render/occlusion.h"

namespace aeolic::gl {
namespace {

constexpr std::size_t kPixelBytes = 4;

void bindSurface(const FrameImages& images)
{
    images.visible.bind(0);
    images.surface.bind(1);
}

}  // namespace

void Occlusion::copyDepths(const Pass& pass, const Extent& compute, int rows)
{
    depths_.hold(compute, rows, pass.view.camera.height);
    pass.timers.begin(Stage::shade);
    const GLuint program = pass.programs.compute("occlusion_depths");
    setExtent(program, 1, compute);
    bindSurface(pass.images);
    bindStorage(0, depths_.words());
    dispatchOver(program, depths_.held());
    pass.timers.end();
}

void Occlusion::findHidden(const Pass& pass, const Extent& compute, int radius, int rows)
{
    hidden_.hold(compute, rows, pass.view.camera.height);
    std::array<GLint, std::size_t(2 * occlusion::kPatterns * occlusion::kTaps)> taps{};
    for (std::size_t k = 0; k < taps.size() / 2; ++k) {
        taps[2 * k] = occlusion::tapPx(occlusion::kRight[k], radius);
        taps[2 * k + 1] = occlusion::tapPx(occlusion::kDown[k], radius);
    }
    pass.timers.begin(Stage::shade);
    const GLuint program = pass.programs.compute("occlusion_hidden");
    setExtent(program, 1, depths_.held());
    setExtent(program, 2, hidden_.held());
    setFloats(program, 3, 0.25f / (float(radius) * float(radius)));
    setPairs(program, 4, occlusion::kPatterns * occlusion::kTaps, taps.data());
    bindSurface(pass.images);
    bindStorage(0, depths_.words());
    bindStorage(1, hidden_.words());
    dispatchOver(program, compute);
    pass.timers.end();
}

void Occlusion::findOpen(const Pass& pass, const Extent& area)
{
    open_.reserve(std::size_t(std::max(area.width(), 0)) * std::size_t(std::max(area.height(), 0)) * sizeof(float));
    pass.timers.begin(Stage::shade);
    const GLuint program = pass.programs.compute("occlusion_open");
    setExtent(program, 1, depths_.held());
    setExtent(program, 2, hidden_.held());
    bindSurface(pass.images);
    bindStorage(0, depths_.words());
    bindStorage(1, hidden_.words());
    bindStorage(2, open_.get());
    dispatchOver(program, area);
    pass.timers.end();
}

void Occlusion::run(const Pass& pass, const Extent& compute, RowExchange* beside, int more)
{
    const int radius = occlusion::radiusPx(pass.view.camera.height), averaged = more + occlusion::kBefore;
    copyDepths(pass, compute, radius + averaged);
    if (beside) depths_.receive(*beside);
    findHidden(pass, compute, radius, averaged);
    if (beside) hidden_.receive(*beside);
    findOpen(pass, compute.empty() ? compute : withNeighbours(compute, pass.images.valid, more));
}

void Shade::draw(Programs& programs, const FrameImages& images, const Palette& palette, bool hasLic,
                 const Extent& shown, const Buffer& open)
{
    shown_ = shown;
    if (shown.empty()) return;
    const PaletteBlock block = makePaletteBlock(palette, hasLic);
    if (block_.bytes() == 0) block_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    block_.write(0, sizeof block, &block);
    const std::vector<ColorTable> tables = makeColorTables(palette);
    tables_.reserve(tables.size() * sizeof(ColorTable));
    tables_.get().write(0, tables.size() * sizeof(ColorTable), tables.data());
    pixels_.reserve(std::size_t(shown.width()) * std::size_t(shown.height()) * kPixelBytes);
    const GLuint program = programs.compute("shade");
    images.visible.bind(0);
    images.surface.bind(1);
    images.flow.bind(2);
    images.lic.bind(3);
    images.bindColors(4, 5);
    bindUniforms(kPaletteBinding, block_);
    bindStorage(kColorTablesBinding, tables_.get());
    bindStorage(0, pixels_.get());
    bindStorage(1, open);
    dispatchOver(program, shown);
}

void Shade::send(const Extent& compute, Tile& out, FrameInFlight& frame) const
{
    frame.rows = compute;
    frame.out = &out;
    if (compute.empty()) return;
    const std::size_t rowBytes = std::size_t(compute.width()) * kPixelBytes;
    frame.timers.begin(Stage::readBack);
    frame.pixels.copy(pixels_.get(), rowBytes * std::size_t(compute.height()),
                      rowBytes * std::size_t(compute.y0 - shown_.y0));
    frame.timers.end();
    frame.pixels.start();
}

}  // namespace aeolic::gl
