#pragma once

#include <string>
#include <vector>

namespace aeolic::gl {

using EglDevice = void*;   ///< EGLDeviceEXT
using EglDisplay = void*;  ///< EGLDisplay

/// A device that EGL lists and that can be opened.
struct Device {
    EglDevice egl = nullptr;
    EglDisplay display = nullptr;  ///< Initialised, for the life of the process.
    bool software = false;         ///< A renderer on the processor, by its own account.
};

/// Local. The devices of this machine, real ones first, else in EGL's order; `withSoftware` also those that only say
/// they are (loading them costs a hundred milliseconds and the memory of a compiler). Throws NoDevice under `--backend`
/// where EGL is missing or lists none, and InputError where it lists GPUs and can open none. Found once, then
/// remembered.
const std::vector<Device>& devices(bool withSoftware);

/// The context's renderer names a program rather than a GPU.
bool isSoftwareRenderer(const std::string& renderer);

}  // namespace aeolic::gl
