#pragma once

#include <memory>

#include "render/backend.h"

namespace aeolic::gl {

/// The stages on a GPU: visibility by the rasterizer, all else in compute shaders, by OpenGL 4.5 without a window.
/// `realOnly`: not on a renderer that is a program. Throws InputError where there is no such device, and where the
/// scene does not fit it.
std::unique_ptr<Backend> makeGlBackend(const Scene& scene, const GpuChoice& choice, bool realOnly);

}  // namespace aeolic::gl
