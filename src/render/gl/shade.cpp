#include "render/gl/shade.h"

#include <cstring>
#include <utility>

#include "base/parallel.h"
#include "render/gl/blocks.h"
#include "render/gl/waiting.h"

namespace aeolic::gl {
Shade::~Shade()
{
    if (copied_) glDeleteSync(copied_);
}

void Shade::start(Programs& programs, const FrameImages& images, const Palette& palette, bool hasLic,
                  const Extent& compute, StageTimers& timers)
{
    compute_ = compute;
    if (compute.empty()) return;
    timers.begin(Stage::shade);
    const PaletteBlock block = makePaletteBlock(palette, hasLic);
    if (block_.bytes() == 0) block_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    block_.write(0, sizeof block, &block);
    const std::size_t bytes = std::size_t(compute.width()) * std::size_t(compute.height()) * 4;
    pixels_.reserve(bytes);
    if (staging_.bytes() < pixels_.get().bytes())
        mapped_ = static_cast<const std::uint8_t*>(mapForReading(staging_, pixels_.get().bytes()));
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
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    timers.end();
    timers.begin(Stage::readBack);
    glCopyNamedBufferSubData(pixels_.get().id(), staging_.id(), 0, 0, GLsizeiptr(bytes));
    glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    timers.end();
    if (copied_) glDeleteSync(copied_);
    copied_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void Shade::finish(Tile& out)
{
    if (compute_.empty()) return;
    waitFor(std::exchange(copied_, nullptr));
    const std::size_t rowBytes = std::size_t(compute_.width()) * 4;
    parallelRanges(std::size_t(compute_.height()), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            std::memcpy(out.row(compute_.y0 + int(i)) + 4 * (compute_.x0 - out.extent.x0), mapped_ + i * rowBytes,
                        rowBytes);
    });
}

}  // namespace aeolic::gl
