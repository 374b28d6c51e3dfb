#pragma once

#include <epoxy/gl.h>

/// What a program gets before it runs: numbers, and buffers that its shaders read and write.
namespace aeolic::gl {

/// The uniform of one to four components at a location, for all runs to come.
template <class... Values>
void setFloats(GLuint program, GLint location, Values... values)
{
    const GLfloat all[] = {static_cast<GLfloat>(values)...};
    static_assert(sizeof...(values) >= 1 && sizeof...(values) <= 4);
    if constexpr (sizeof...(values) == 1) glProgramUniform1fv(program, location, 1, all);
    if constexpr (sizeof...(values) == 2) glProgramUniform2fv(program, location, 1, all);
    if constexpr (sizeof...(values) == 3) glProgramUniform3fv(program, location, 1, all);
    if constexpr (sizeof...(values) == 4) glProgramUniform4fv(program, location, 1, all);
}

template <class... Values>
void setInts(GLuint program, GLint location, Values... values)
{
    const GLint all[] = {static_cast<GLint>(values)...};
    static_assert(sizeof...(values) >= 1 && sizeof...(values) <= 3);
    if constexpr (sizeof...(values) == 1) glProgramUniform1iv(program, location, 1, all);
    if constexpr (sizeof...(values) == 2) glProgramUniform2iv(program, location, 1, all);
    if constexpr (sizeof...(values) == 3) glProgramUniform3iv(program, location, 1, all);
}

inline void setUnsigned(GLuint program, GLint location, GLuint value)
{
    glProgramUniform1ui(program, location, value);
}

/// An array of `count` pairs.
inline void setPairs(GLuint program, GLint location, GLsizei count, const GLfloat* pairs)
{
    glProgramUniform2fv(program, location, count, pairs);
}
inline void setPairs(GLuint program, GLint location, GLsizei count, const GLint* pairs)
{
    glProgramUniform2iv(program, location, count, pairs);
}

/// Where shaders find a buffer, by the number in their layout.
template <class AnyBuffer>
void bindStorage(GLuint binding, const AnyBuffer& buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.id());
}
template <class AnyBuffer>
void bindUniforms(GLuint binding, const AnyBuffer& buffer)
{
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.id());
}

/// While it exists, Texture::readRows() or writeRows() takes offsets in a buffer's memory instead of pointers.
template <GLenum kTarget>
class PixelMemory {
public:
    template <class AnyBuffer>
    explicit PixelMemory(const AnyBuffer& buffer)
    {
        glBindBuffer(kTarget, buffer.id());
    }
    ~PixelMemory() { glBindBuffer(kTarget, 0); }
    PixelMemory(const PixelMemory&) = delete;
};
using PixelsInto = PixelMemory<GL_PIXEL_PACK_BUFFER>;    ///< For readRows().
using PixelsFrom = PixelMemory<GL_PIXEL_UNPACK_BUFFER>;  ///< For writeRows().

}  // namespace aeolic::gl
