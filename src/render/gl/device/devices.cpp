#include "render/gl/device/devices.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <algorithm>
#include <mutex>

#include "base/text.h"
#include "render/gl/gl_backend.h"

namespace aeolic::gl {
namespace {

template <class Error = NoDevice>
[[noreturn]] void notHere(const std::string& why)
{
    throw Error("--backend", "gl, but " + why, "a GPU driver with EGL and OpenGL 4.5 (docs/gpu.md), or cpu");
}

// libepoxy ends the process where libEGL is missing: looked for before it is called.
void requireEgl()
{
    void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (!library) notHere("there is no libEGL.so.1");
    dlclose(library);
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!epoxy_extension_in_string(extensions, "EGL_EXT_platform_device") ||
        !(epoxy_extension_in_string(extensions, "EGL_EXT_device_base") ||
          epoxy_extension_in_string(extensions, "EGL_EXT_device_enumeration")))
        notHere("this EGL cannot list devices (EGL_EXT_device_enumeration)");
}

std::vector<Device> listed()
{
    requireEgl();
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count == 0) notHere("EGL lists no device");
    std::vector<EGLDeviceEXT> all(std::size_t(count), nullptr);
    eglQueryDevicesEXT(count, all.data(), &count);
    std::vector<Device> found;
    for (int i = 0; i < count; ++i) {
        const char* extensions = eglQueryDeviceStringEXT(all[std::size_t(i)], EGL_EXTENSIONS);
        found.push_back(
            {all[std::size_t(i)], nullptr, epoxy_extension_in_string(extensions, "EGL_MESA_device_software")});
    }
    std::stable_partition(found.begin(), found.end(), [](const Device& d) { return !d.software; });
    return found;
}

// Devices of others (another container's, another user's) are listed too, and cannot be opened.
std::vector<Device> opened(std::vector<Device> found)
{
    std::erase_if(found, [](Device& d) {
        d.display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, d.egl, nullptr);
        return d.display == EGL_NO_DISPLAY || !eglInitialize(d.display, nullptr, nullptr);
    });
    return found;
}

}  // namespace

bool isSoftwareRenderer(const std::string& renderer)
{
    const std::string lower = lowerCase(renderer);
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "swr", "software"})
        if (lower.find(name) != std::string::npos) return true;
    return false;
}

const std::vector<Device>& devices(bool withSoftware)
{
    static std::mutex mutex;
    static std::vector<Device> known[2];
    const std::lock_guard lock(mutex);
    std::vector<Device>& result = known[withSoftware];
    if (!result.empty()) return result;
    std::vector<Device> found = listed();
    if (!withSoftware) std::erase_if(found, [](const Device& d) { return d.software; });
    if (found.empty()) notHere("EGL lists software renderers alone, no GPU");
    found = opened(std::move(found));
    const std::string closed = "EGL could open none of its devices (is /dev/dri or /dev/nvidia* readable?)";
    if (found.empty()) withSoftware ? notHere(closed) : notHere<InputError>(closed);  // A GPU is there.
    return result = std::move(found);
}

}  // namespace aeolic::gl
