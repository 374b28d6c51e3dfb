#pragma once

#include "base/extent.h"
#include "render/gl/device/objects.h"

/// How programs run. Nothing that a shader writes is seen by what follows unless a barrier stands between them. So one
/// stands behind every program, here, for all that may follow: programs, draws, uploads, copies and clears. Most
/// programs need what the one before them wrote, so that a device loses next to nothing by it.
namespace aeolic::gl {

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
