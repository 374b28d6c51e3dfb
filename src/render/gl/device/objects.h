#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace aeolic::gl {

/// Owns one OpenGL name; `Delete`, a function of OpenGL, gets it back. Made and destroyed while its context is current.
template <auto& Delete>
class Name {
public:
    Name() = default;
    explicit Name(GLuint id) : id_(id) {}
    Name(Name&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Name& operator=(Name&& other) noexcept
    {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Name()
    {
        if (!id_) return;
        if constexpr (std::is_invocable_v<decltype(Delete), GLuint>)
            Delete(id_);
        else
            Delete(1, &id_);
    }
    operator GLuint() const { return id_; }

private:
    GLuint id_ = 0;
};

using Program = Name<glDeleteProgram>;
using Framebuffer = Name<glDeleteFramebuffers>;
using VertexArray = Name<glDeleteVertexArrays>;
using Query = Name<glDeleteQueries>;

/// Memory of the device, of fixed size. Throws OutOfMemory where the device has no more.
class Buffer {
public:
    Buffer() = default;
    /// `flags` as of glNamedBufferStorage. Sizes of 0 become one word: shaders may always bind it.
    Buffer(std::size_t bytes, GLbitfield flags, const void* data = nullptr);

    GLuint id() const { return name_; }
    std::size_t bytes() const { return bytes_; }
    void write(std::size_t offset, std::size_t bytes, const void* data) const;
    /// Its beginning becomes what `head` holds. The device does it: a buffer that the host writes again and again may
    /// be moved to the host's memory by its driver, and what shaders do with it there is slow.
    void begin(const Buffer& head) const;

private:
    Name<glDeleteBuffers> name_;
    std::size_t bytes_ = 0;
};

/// A buffer that grows when it must, by a quarter at least, so that sizes that creep up do not allocate every frame.
class GrowingBuffer {
public:
    explicit GrowingBuffer(GLbitfield flags) : flags_(flags) {}
    /// At least `bytes`; contents are lost when it grows.
    const Buffer& reserve(std::size_t bytes);
    const Buffer& get() const { return buffer_; }

private:
    GLbitfield flags_;
    Buffer buffer_;
};

/// A texture of fixed size and one level: texels are fetched one by one or gathered by fours; never filtered. Beyond
/// the border it is zero. Its contents are zero at first. Throws OutOfMemory where the device has no more.
class Texture {
public:
    Texture() = default;
    static Texture image(GLenum format, int width, int height);
    static Texture layers(GLenum format, int width, int height, int layers);
    static Texture volume(GLenum format, int width, int height, int depth);

    GLuint id() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    int width() const { return width_; }
    int height() const { return height_; }
    int depth() const { return depth_; }  ///< Or layers.
    GLenum format() const { return format_; }
    bool layered() const { return layered_; }

    void bind(GLuint unit) const { glBindTextureUnit(unit, name_); }
    /// For imageStore, all layers.
    void bindImage(GLuint unit) const;
    /// Zeros in rows [y0, y1), all layers.
    void clearRows(int y0, int y1) const;
    /// Rows [y0, y1) of a layer, without padding. Where a pixel buffer is bound, pointers are offsets into it.
    void readRows(int y0, int y1, int layer, void* to) const;
    void writeRows(int y0, int y1, int layer, const void* from) const;
    /// All texels of a texture of one layer, to one of the same size and format.
    void copyTo(const Texture& other) const;

private:
    Texture(GLenum target, GLenum format, int width, int height, int depth);

    Name<glDeleteTextures> name_;
    GLenum format_ = 0;
    bool layered_ = false;
    int width_ = 0, height_ = 0, depth_ = 1;
};

/// Client format and type of a texture's texels, and their bytes.
struct TexelFormat {
    GLenum format, type;
    int bytes;
};
TexelFormat texelFormat(GLenum internalFormat);

}  // namespace aeolic::gl
