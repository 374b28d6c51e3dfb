#include "render/gl/device/read_back.h"

#include <utility>

#include "render/gl/device/device_errors.h"

namespace aeolic::gl {
namespace {

constexpr GLuint64 kPatienceNs = 60'000'000'000;  // No frame takes that long.

}  // namespace

Fence::~Fence()
{
    if (sync_) glDeleteSync(sync_);
}

void Fence::set()
{
    if (sync_) glDeleteSync(sync_);
    sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void Fence::wait()
{
    if (!sync_) return;
    const GLsync sync = std::exchange(sync_, nullptr);
    const GLenum state = glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, kPatienceNs);
    glDeleteSync(sync);
    requireNoReset();
    if (state == GL_TIMEOUT_EXPIRED) deviceFailed("it does not finish its frame: it hangs, or was reset");
    if (state == GL_WAIT_FAILED) {
        checkErrors("waiting for the device");
        deviceFailed("its driver cannot wait for it");
    }
}

SharedMemory::SharedMemory(bool alsoWritten)
    : access_(GL_MAP_READ_BIT | (alsoWritten ? GL_MAP_WRITE_BIT : 0) | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT),
      buffer_(access_ | GL_CLIENT_STORAGE_BIT)
{
}

std::byte* SharedMemory::reserve(std::size_t bytes)
{
    const GLuint before = id();
    const std::size_t sizeBefore = buffer_.get().bytes();
    buffer_.reserve(bytes);
    if (id() != before || buffer_.get().bytes() != sizeBefore) {
        mapped_ = static_cast<std::byte*>(glMapNamedBufferRange(id(), 0, GLsizeiptr(buffer_.get().bytes()), access_));
        if (!mapped_) deviceFailed("its driver maps no memory to read from it");
    }
    return mapped_;
}

void ReadBack::copy(const Buffer& from, std::size_t bytes, std::size_t offset)
{
    memory_.reserve(bytes);
    glCopyNamedBufferSubData(from.id(), memory_.id(), GLintptr(offset), 0, GLsizeiptr(bytes));
}

const std::byte* ReadBack::wait()
{
    copied_.wait();
    return memory_.data();
}

}  // namespace aeolic::gl
