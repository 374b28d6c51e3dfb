#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>

/// Preloaded (LD_PRELOAD), makes a device fail in any program that draws by libepoxy, or looks at what it is asked for:
/// AEOLIC_TEST_RESET=FILE     it was reset, as long as FILE exists
/// AEOLIC_TEST_MEMORY=BYTES   it has no memory for any texture of more
/// AEOLIC_TEST_OVERLAP=FILE   makes FILE when a frame is waited for after the next was begun
namespace {

bool exhausted = false;

/// What is behind the name where libepoxy has not looked yet.
template <class Function>
Function original(const char* name, Function)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

GLenum resetStatus()
{
    static const auto real = original("glGetGraphicsResetStatus", epoxy_glGetGraphicsResetStatus);
    const char* file = std::getenv("AEOLIC_TEST_RESET");
    return file && access(file, F_OK) == 0 ? GL_GUILTY_CONTEXT_RESET : real();
}

GLenum error()
{
    static const auto real = original("glGetError", epoxy_glGetError);
    if (!exhausted) return real();
    exhausted = false;
    return GL_OUT_OF_MEMORY;
}

void textureStorage2D(GLuint id, GLsizei levels, GLenum format, GLsizei width, GLsizei height)
{
    static const auto real = original("glTextureStorage2D", epoxy_glTextureStorage2D);
    const char* most = std::getenv("AEOLIC_TEST_MEMORY");
    if (most && 4L * width * height > std::atol(most))
        exhausted = true;
    else
        real(id, levels, format, width, height);
}

std::mutex mutex;
long surfacesDrawn = 0;  // Every frame begins with that, and sets fences behind it.
std::map<GLsync, long> drawnBefore;

void drawElements(GLenum mode, GLsizei count, GLenum type, const void* indices)
{
    static const auto real = original("glDrawElements", epoxy_glDrawElements);
    const std::lock_guard lock(mutex);
    ++surfacesDrawn;
    real(mode, count, type, indices);
}

GLsync fenceSync(GLenum condition, GLbitfield flags)
{
    static const auto real = original("glFenceSync", epoxy_glFenceSync);
    const GLsync sync = real(condition, flags);
    const std::lock_guard lock(mutex);
    drawnBefore[sync] = surfacesDrawn;
    return sync;
}

GLenum clientWaitSync(GLsync sync, GLbitfield flags, GLuint64 timeout)
{
    static const auto real = original("glClientWaitSync", epoxy_glClientWaitSync);
    {
        const std::lock_guard lock(mutex);
        const char* file = std::getenv("AEOLIC_TEST_OVERLAP");
        if (file && drawnBefore[sync] != surfacesDrawn) std::ofstream(file).put('1');
    }
    return real(sync, flags, timeout);
}

__attribute__((constructor)) void install()
{
    epoxy_glGetGraphicsResetStatus = resetStatus;
    epoxy_glGetError = error;
    epoxy_glTextureStorage2D = textureStorage2D;
    epoxy_glDrawElements = drawElements;
    epoxy_glFenceSync = fenceSync;
    epoxy_glClientWaitSync = clientWaitSync;
}

}  // namespace
