#include "render/gl/shade/gl_shade.h"

#include "render/gl/device/dispatch.h"
#include "render/gl/device/gl_blocks.h"

namespace aeolic::gl {
namespace {

constexpr std::size_t kPixelBytes = 4;

}  // namespace

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
