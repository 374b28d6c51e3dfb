#pragma once

#include "render/backend_kinds.h"

namespace aeolic::gl {

/// The stages on a GPU: visibility by the rasterizer, all else in compute shaders, by OpenGL 4.5 without a window.
extern const BackendKind kind;

/// Local. BackendKind::identity and requireRoom of it.
std::string deviceIdentity(const DeviceRequest& request);
void requireRoom(const std::vector<SceneSizes>& steps, const DeviceRequest& request, int ranks);

}  // namespace aeolic::gl
