#include "render/gl/row_counts.h"

#include <algorithm>
#include <utility>

#include "render/gl/waiting.h"

namespace aeolic::gl {

RowCounts::~RowCounts()
{
    if (done_) glDeleteSync(done_);
}

void RowCounts::start(Programs& programs, const Texture& visible, int y0, int y1)
{
    y0_ = y0;
    y1_ = y1;
    if (y0 >= y1) return;
    const std::size_t bytes = std::size_t(y1 - y0) * 4;
    counts_.reserve(bytes);
    if (staging_.bytes() < counts_.get().bytes())
        mapped_ = static_cast<const std::uint32_t*>(mapForReading(staging_, counts_.get().bytes()));
    const GLuint program = programs.compute("count_rows");
    glProgramUniform3i(program, 0, y0, y1 - y0, visible.width());
    glUseProgram(program);
    visible.bind(0);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, counts_.get().id());
    glDispatchCompute(GLuint(y1 - y0), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(counts_.get().id(), staging_.id(), 0, 0, GLsizeiptr(bytes));
    glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    if (done_) glDeleteSync(done_);
    done_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void RowCounts::wait()
{
    if (done_) waitFor(std::exchange(done_, nullptr));
}

std::int64_t RowCounts::get(int y0, int y1) const
{
    std::int64_t sum = 0;
    for (int y = std::max(y0, y0_); y < std::min(y1, y1_); ++y) sum += mapped_[y - y0_];
    return sum;
}

}  // namespace aeolic::gl
