#include "render/gl/device/objects.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "render/gl/device/device_errors.h"

namespace aeolic::gl {
namespace {

std::string sizeText(int width, int height, int depth)
{
    const std::string image = std::to_string(width) + "x" + std::to_string(height);
    return depth > 1 ? image + "x" + std::to_string(depth) : image;
}

}  // namespace

Buffer::Buffer(std::size_t bytes, GLbitfield flags, const void* data) : bytes_(std::max<std::size_t>(bytes, 4))
{
    GLuint id = 0;
    glCreateBuffers(1, &id);
    name_ = Name<glDeleteBuffers>(id);
    glNamedBufferStorage(id, GLsizeiptr(bytes_), bytes ? data : nullptr, flags);
    checkAllocation("a buffer", bytes_);
}

void Buffer::write(std::size_t offset, std::size_t bytes, const void* data) const
{
    if (bytes) glNamedBufferSubData(name_, GLintptr(offset), GLsizeiptr(bytes), data);
}

void Buffer::begin(const Buffer& head) const
{
    glCopyNamedBufferSubData(head.name_, name_, 0, 0, GLsizeiptr(head.bytes_));
}

const Buffer& GrowingBuffer::reserve(std::size_t bytes)
{
    if (bytes > buffer_.bytes()) {
        const std::size_t grown = std::max(bytes, buffer_.bytes() + buffer_.bytes() / 4);
        buffer_ = Buffer();  // Before the new one is taken: never both.
        buffer_ = Buffer(grown, flags_);
    }
    return buffer_;
}

TexelFormat texelFormat(GLenum internalFormat)
{
    switch (internalFormat) {
        case GL_R8UI:
            return {GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1};
        case GL_R32UI:
            return {GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
        case GL_RG32UI:
            return {GL_RG_INTEGER, GL_UNSIGNED_INT, 8};
        case GL_R32F:
            return {GL_RED, GL_FLOAT, 4};
        case GL_RGBA32F:
            return {GL_RGBA, GL_FLOAT, 16};
        case GL_RGBA16F:
            return {GL_RGBA, GL_HALF_FLOAT, 8};
        case GL_DEPTH_COMPONENT32F:
            return {GL_DEPTH_COMPONENT, GL_FLOAT, 4};
        default:
            throw std::logic_error("gl: a texel format without a name");
    }
}

Texture::Texture(GLenum target, GLenum format, int width, int height, int depth)
    : format_(format), layered_(target != GL_TEXTURE_2D), width_(width), height_(height), depth_(depth)
{
    GLuint id = 0;
    glCreateTextures(target, 1, &id);
    name_ = Name<glDeleteTextures>(id);
    if (target == GL_TEXTURE_2D)
        glTextureStorage2D(id, 1, format, width, height);
    else
        glTextureStorage3D(id, 1, format, width, height, depth);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(id, axis, GL_CLAMP_TO_BORDER);
    const std::array<GLuint, 4> zero{};
    if (texelFormat(format).format == GL_RED_INTEGER || texelFormat(format).format == GL_RG_INTEGER)
        glTextureParameterIuiv(id, GL_TEXTURE_BORDER_COLOR, zero.data());
    checkAllocation(
        "a texture of " + sizeText(width, height, depth),
        std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(depth) * std::uint64_t(texelFormat(format).bytes));
    // Volumes are filled as a whole; the others must not show what the memory held.
    if (target != GL_TEXTURE_3D) glClearTexImage(id, 0, texelFormat(format).format, texelFormat(format).type, nullptr);
}

Texture Texture::image(GLenum format, int width, int height)
{
    return {GL_TEXTURE_2D, format, width, height, 1};
}
Texture Texture::layers(GLenum format, int width, int height, int layers)
{
    return {GL_TEXTURE_2D_ARRAY, format, width, height, layers};
}
Texture Texture::volume(GLenum format, int width, int height, int depth)
{
    return {GL_TEXTURE_3D, format, width, height, depth};
}

void Texture::bindImage(GLuint unit) const
{
    glBindImageTexture(unit, name_, 0, GL_TRUE, 0, GL_READ_WRITE, format_);
}

void Texture::clearRows(int y0, int y1) const
{
    const TexelFormat texel = texelFormat(format_);
    if (y0 < y1) glClearTexSubImage(name_, 0, 0, y0, 0, width_, y1 - y0, depth_, texel.format, texel.type, nullptr);
}

void Texture::copyTo(const Texture& other) const
{
    glCopyImageSubData(name_, GL_TEXTURE_2D, 0, 0, 0, 0, other.name_, GL_TEXTURE_2D, 0, 0, 0, 0, width_, height_, 1);
}

void Texture::readRows(int y0, int y1, int layer, void* to) const
{
    const TexelFormat texel = texelFormat(format_);
    const std::size_t rowBytes = std::size_t(width_) * std::size_t(texel.bytes);
    const int most = int(std::max<std::size_t>((std::size_t{1} << 30) / rowBytes, 1));  // Bytes are counted in an int.
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = y0; y < y1; y += most) {
        const int rows = std::min(most, y1 - y);
        glGetTextureSubImage(name_, 0, 0, y, layer, width_, rows, 1, texel.format, texel.type,
                             GLsizei(rowBytes * std::size_t(rows)),
                             static_cast<std::byte*>(to) + rowBytes * std::size_t(y - y0));
    }
}

void Texture::writeRows(int y0, int y1, int layer, const void* from) const
{
    if (y0 >= y1) return;
    const TexelFormat texel = texelFormat(format_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (layered_)
        glTextureSubImage3D(name_, 0, 0, y0, layer, width_, y1 - y0, 1, texel.format, texel.type, from);
    else
        glTextureSubImage2D(name_, 0, 0, y0, width_, y1 - y0, texel.format, texel.type, from);
}

}  // namespace aeolic::gl
