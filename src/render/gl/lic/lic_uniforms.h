#pragma once

#include "render/gl/lic/convolve.h"
#include "render/lic_kernel.h"

namespace aeolic::gl {

/// Textures and uniforms of trace.glsl.
void bindTraces(const ConvolvePass& pass, GLuint program);

/// Uniforms of lic_value.glsl.
void setContrast(GLuint program, const LicOptions& lic);

}  // namespace aeolic::gl
