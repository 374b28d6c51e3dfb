#include "render/gl/waiting.h"

#include <stdexcept>

namespace aeolic::gl {
namespace {

constexpr GLuint64 kPatienceNs = 60'000'000'000;  // No frame takes that long.
constexpr GLbitfield kMapped = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

}  // namespace

void waitFor(GLsync fence)
{
    const GLenum state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kPatienceNs);
    glDeleteSync(fence);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED)
        throw std::runtime_error("gl: the GPU does not finish its frame: it hangs, or was reset");
}

const void* mapForReading(Buffer& buffer, std::size_t bytes)
{
    buffer = Buffer();
    buffer = Buffer(bytes, kMapped | GL_CLIENT_STORAGE_BIT);
    const void* mapped = glMapNamedBufferRange(buffer.id(), 0, GLsizeiptr(buffer.bytes()), kMapped);
    if (!mapped) throw std::runtime_error("gl: the driver maps no memory to read pixels from");
    return mapped;
}

}  // namespace aeolic::gl
