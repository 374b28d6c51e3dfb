#include "render/gl/device/device_errors.h"

#include <epoxy/gl.h>

#include "render/gl/device/gl_limits.h"

namespace aeolic::gl {
namespace {

thread_local const std::string* device = nullptr;

[[noreturn]] void outOfMemory(const std::string& what)
{
    const auto free = freeMemoryBytes();
    throw OutOfMemory("gl: " + (device ? *device + ": " : "") + "out of memory " + what +
                      (free ? " (" + megabytes(*free) + " are free)" : "") +
                      ": fewer ranks on this GPU, or a smaller picture");
}

// The first error since the last look, and none left. A lost context reports its loss without end.
GLenum takeError()
{
    const GLenum first = glGetError();
    for (int more = 0; more < 16 && first != GL_NO_ERROR && glGetError() != GL_NO_ERROR; ++more) {
    }
    return first;
}

void throwIf(GLenum error, const std::string& doing)
{
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY) outOfMemory(doing);
    if (error == GL_CONTEXT_LOST) deviceFailed("it was reset while " + doing + ", and its context is lost");
    deviceFailed("OpenGL error " + std::to_string(error) + " while " + doing);
}

}  // namespace

std::string megabytes(std::uint64_t bytes)
{
    return std::to_string(bytes >> 20) + " MB";
}

void errorsAreOf(const std::string* renderer)
{
    device = renderer;
}

void deviceFailed(const std::string& what)
{
    throw DeviceError("gl: " + (device ? *device + ": " : "") + what);
}

void checkErrors(const std::string& doing)
{
    throwIf(takeError(), doing);
}

void checkAllocation(const std::string& what, std::uint64_t bytes)
{
    const GLenum error = takeError();
    if (error != GL_NO_ERROR) throwIf(error, "allocating " + what + " of " + megabytes(bytes));
}

void requireNoReset()
{
    switch (glGetGraphicsResetStatus()) {
        case GL_NO_ERROR:
            return;
        case GL_GUILTY_CONTEXT_RESET:
            deviceFailed("it was reset for what this rank drew, and its context is lost");
        case GL_INNOCENT_CONTEXT_RESET:
            deviceFailed("it was reset for what another program did, and its context is lost");
        default:
            deviceFailed("it was reset, and its context is lost");
    }
}

}  // namespace aeolic::gl
