#pragma once

#include <memory>

#include "aeolic/error.h"
#include "render/backend.h"

namespace aeolic::gl {

/// There is no GPU at all, or nothing to reach one by.
struct NoGpu : InputError {
    using InputError::InputError;
};

/// The stages on a GPU: visibility by the rasterizer, all else in compute shaders, by OpenGL 4.5 without a window.
/// `realOnly`: not on a renderer that is a program. Throws InputError where there is no such device (NoGpu
/// where there is none), and where the scene does not fit it.
std::unique_ptr<Backend> makeGlBackend(const Scene& scene, const GpuChoice& choice, bool realOnly);

}  // namespace aeolic::gl
