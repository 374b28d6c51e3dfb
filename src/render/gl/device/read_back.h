#pragma once

#include "render/gl/device/objects.h"

namespace aeolic::gl {

/// Where a pixel buffer is bound, pointers are offsets into it.
inline void* offsetPointer(std::size_t offset)
{
    return reinterpret_cast<void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

/// A point in the device's work that this process can wait for.
class Fence {
public:
    Fence() = default;
    ~Fence();
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    /// Behind the commands given so far. One set before is forgotten.
    void set();
    bool pending() const { return sync_ != nullptr; }
    /// Nothing where none is pending. Throws DeviceError where the device hangs or was reset.
    void wait();

private:
    GLsync sync_ = nullptr;
};

/// Memory that device and process both see for as long as it lives, fast for the processor to read.
class SharedMemory {
public:
    explicit SharedMemory(bool alsoWritten = false);

    /// At least `bytes`; contents are lost when it grows.
    std::byte* reserve(std::size_t bytes);
    std::byte* data() const { return mapped_; }
    GLuint id() const { return buffer_.get().id(); }

private:
    GLbitfield access_;
    GrowingBuffer buffer_;
    std::byte* mapped_ = nullptr;
};

/// While it exists, Texture::readRows() or writeRows() takes offsets in a shared memory instead of pointers.
template <GLenum kTarget>
class PixelMemory {
public:
    explicit PixelMemory(const SharedMemory& memory) { glBindBuffer(kTarget, memory.id()); }
    ~PixelMemory() { glBindBuffer(kTarget, 0); }
    PixelMemory(const PixelMemory&) = delete;
};
using PixelsInto = PixelMemory<GL_PIXEL_PACK_BUFFER>;    ///< For readRows().
using PixelsFrom = PixelMemory<GL_PIXEL_UNPACK_BUFFER>;  ///< For writeRows().

/// Bytes on their way from the device to this process, while both do something else.
class ReadBack {
public:
    /// Queues a copy of `bytes` of `from`, from `offset` on, as the commands given so far leave them.
    void copy(const Buffer& from, std::size_t bytes, std::size_t offset = 0);
    /// After copy(): from now on it can be waited for.
    void start() { copied_.set(); }
    bool pending() const { return copied_.pending(); }
    /// Waits for them. They are there until the next copy().
    const std::byte* wait();

private:
    SharedMemory memory_;
    Fence copied_;
};

}  // namespace aeolic::gl
