#pragma once

#include "base/extent.h"
#include "render/gl/device/objects.h"

/// How programs run, and what they get before: numbers, and buffers that their shaders read and write. Nothing that a
/// shader writes is seen by what follows unless a barrier stands between them. So one stands behind every program,
/// here, for all that may follow: programs, draws, uploads, copies and clears. Most programs need what the one before
/// them wrote, so that a device loses next to nothing by it.
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
inline void bindStorage(GLuint binding, const Buffer& buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.id());
}
inline void bindUniforms(GLuint binding, const Buffer& buffer)
{
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.id());
}

/// Sets a uniform `ivec4` of x0, y0, x1, y1.
void setExtent(GLuint program, GLint location, const Extent& area);

/// Runs a compute program in so many workgroups.
void dispatch(GLuint program, GLuint groupsX, GLuint groupsY = 1, GLuint groupsZ = 1);

/// The same, in as many as `groups` says from `offset` bytes on.
void dispatchIndirect(GLuint program, const Buffer& groups, std::size_t offset);

/// Runs a program over `area`, which it gets as the uniform at location 0. Its groups are `groupWidth` x 8 pixels.
void dispatchOver(GLuint program, const Extent& area, int groupWidth = 16);

/// Begins what was asked for, without waiting for it.
void startWork();

/// Behind draws: what they wrote is there for all that follows.
void finishDrawing();

}  // namespace aeolic::gl
