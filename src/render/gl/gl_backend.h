#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/scene_sizes.h"
#include "render/backend.h"

namespace aeolic::gl {

/// There is no GPU at all, or nothing to reach one by.
struct NoGpu : InputError {
    using InputError::InputError;
};

/// Local. What tells the device of `choice` apart from the others of its host; empty where its driver does not say.
/// Throws InputError as makeGlBackend() for a device that is not to be had.
std::string deviceIdentity(const GpuChoice& choice, bool realOnly);

/// Local. Throws InputError where a scene does not fit the device, which `ranks` with as much to load are about to draw
/// on, and says how many ranks would be enough. `steps`: its sizes, one after the other, at the moments it is shown at.
void requireRoom(const std::vector<SceneSizes>& steps, const GpuChoice& choice, bool realOnly, int ranks);

/// The stages on a GPU: visibility by the rasterizer, all else in compute shaders, by OpenGL 4.5 without a window.
/// `realOnly`: not on a renderer that is a program. Throws InputError where there is no such device (NoGpu
/// where there is none), and where the scene does not fit it.
std::unique_ptr<Backend> makeGlBackend(const Scene& scene, const GpuChoice& choice, bool realOnly);

}  // namespace aeolic::gl
