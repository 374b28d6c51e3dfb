#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "render/backend_kinds.h"
#include "render/gl/device/devices.h"
#include "render/gl/device/programs.h"

namespace aeolic::gl {

/// Whether what a driver says is a fault of the program's, by GL_DEBUG_TYPE_… and GL_DEBUG_SEVERITY_…: errors and
/// undefined behaviour always, and of the rest what the driver itself finds grave. Not how fast something is, where
/// buffers lie, nor advice, of which drivers give different amounts.
bool isFault(unsigned type, unsigned severity);

/// An OpenGL 4.5 core context without a window, and its programs. Several on one device work. One thread at a time uses
/// it: bind() before any call, release() when another thread may come. Between them errors name its device.
class Context {
public:
    /// Throws InputError where there is no such device, or none with OpenGL 4.5.
    explicit Context(const DeviceRequest& request);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void bind();              ///< Throws DeviceError where the device was reset.
    bool tryBind() noexcept;  ///< false instead.
    void release() noexcept;

    const std::string& renderer() const { return renderer_; }
    Programs& programs() { return programs_; }

    /// Throws DeviceError with what the driver had to say: in debug builds, and where AEOLIC_GL_DEBUG is set. Also
    /// after an error, out of memory or a reset of the GPU.
    void check(const char* doing);

private:
    void create(const Device& device);
    void listen();

    EglDisplay display_ = nullptr;
    void* context_ = nullptr;
    std::string renderer_;
    Programs programs_;
    std::mutex mutex_;  // Drivers may report from threads of their own.
    std::string messages_;
    bool listens_ = false;
};

/// Contexts that are not in use are kept with their compiled programs for the next caller with the same choice: a
/// server that loads one scene after another, and tests.
std::shared_ptr<Context> acquireContext(const DeviceRequest& request);

}  // namespace aeolic::gl
