#include "render/gl/shade/shade.h"

#include "render/gl/device/blocks.h"

namespace aeolic::gl {

void Shade::start(Programs& programs, const FrameImages& images, const Palette& palette, bool hasLic,
                  const Extent& compute, Tile& out, FrameInFlight& frame)
{
    frame.rows = compute;
    frame.out = &out;
    out.setBackground(palette.background);
    if (compute.empty()) return;
    frame.timers.begin(Stage::shade);
    const PaletteBlock block = makePaletteBlock(palette, hasLic);
    if (block_.bytes() == 0) block_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    block_.write(0, sizeof block, &block);
    const std::size_t bytes = std::size_t(compute.width()) * std::size_t(compute.height()) * 4;
    pixels_.reserve(bytes);
    const GLuint program = programs.compute("shade");
    glProgramUniform4i(program, 0, compute.x0, compute.y0, compute.x1, compute.y1);
    glUseProgram(program);
    images.visible.bind(0);
    images.surface.bind(1);
    images.flow.bind(2);
    images.lic.bind(3);
    if (images.scalar) images.scalar.bind(4);
    glBindBufferBase(GL_UNIFORM_BUFFER, kPaletteBinding, block_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, pixels_.get().id());
    glDispatchCompute(GLuint(compute.width() + 15) / 16, GLuint(compute.height() + 7) / 8, 1);
    frame.timers.end();
    frame.timers.begin(Stage::readBack);
    frame.pixels.copy(pixels_.get(), bytes);
    frame.timers.end();
    frame.pixels.start();
}

}  // namespace aeolic::gl
