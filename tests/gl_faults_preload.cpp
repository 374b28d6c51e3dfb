#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>

/// A library for LD_PRELOAD. In any program that draws by libepoxy it makes a device fail, or watches what it is asked:
/// AEOLIC_TEST_RESET=FILE     it was reset, as long as FILE exists
/// AEOLIC_TEST_MEMORY=BYTES   it has no memory for any texture of more
/// AEOLIC_TEST_OVERLAP=FILE   makes FILE when a frame is waited for after the next was begun
/// AEOLIC_TEST_SIDE=SAMPLES   takes no textures in three dimensions of longer sides
/// AEOLIC_TEST_FREE=BYTES     tells how much of its 80 GB of memory is free, and who it is
///                            (with AEOLIC_TEST_REAL: what a program tells of memory is not believed)
/// AEOLIC_TEST_REAL=1         is no program, by its own account
/// AEOLIC_TEST_OLD=1          its driver is too old
/// AEOLIC_TEST_CLOSED=1       cannot be opened
namespace {

bool exhausted = false;

/// The function of that name, looked up because libepoxy may not have done so yet.
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

void integer64(GLenum name, GLint64* value)
{
    static const auto real = original("glGetInteger64v", epoxy_glGetInteger64v);
    const char* side = std::getenv("AEOLIC_TEST_SIDE");
    if (side && name == GL_MAX_3D_TEXTURE_SIZE)
        *value = std::atol(side);
    else
        real(name, value);
}

// The last of the device's extensions are these.
constexpr const char* kMoreExtensions[] = {"GL_NVX_gpu_memory_info", "GL_EXT_memory_object"};
constexpr GLuint kMore = 2;

void integer(GLenum name, GLint* value)
{
    static const auto real = original("glGetIntegerv", epoxy_glGetIntegerv);
    const char* bytes = std::getenv("AEOLIC_TEST_FREE");
    if (bytes && name == GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX) {
        *value = GLint(std::atol(bytes) >> 10);
        return;
    }
    if (bytes && name == GL_GPU_MEMORY_INFO_DEDICATED_VIDMEM_NVX) {
        *value = 80 << 20;  // 80 GB.
        return;
    }
    real(name, value);
    if (bytes && name == GL_NUM_EXTENSIONS) *value += GLint(kMore);
}

const GLubyte* stringAt(GLenum name, GLuint index)
{
    static const auto real = original("glGetStringi", epoxy_glGetStringi);
    if (std::getenv("AEOLIC_TEST_FREE") && name == GL_EXTENSIONS) {
        GLint count = 0;
        integer(GL_NUM_EXTENSIONS, &count);
        const GLuint first = GLuint(count) - kMore;
        if (index >= first) return reinterpret_cast<const GLubyte*>(kMoreExtensions[index - first]);
    }
    return real(name, index);
}

void identity(GLenum, GLuint, GLubyte* data)
{
    std::fill_n(data, GL_UUID_SIZE_EXT, GLubyte{7});
}

const GLubyte* string(GLenum name)
{
    static const auto real = original("glGetString", epoxy_glGetString);
    if (std::getenv("AEOLIC_TEST_REAL") && name == GL_RENDERER) return reinterpret_cast<const GLubyte*>("A test's GPU");
    return real(name);
}

const char* deviceString(EGLDeviceEXT device, EGLint name)
{
    static const auto real = original("eglQueryDeviceStringEXT", epoxy_eglQueryDeviceStringEXT);
    return std::getenv("AEOLIC_TEST_REAL") ? "" : real(device, name);
}

EGLContext createContext(EGLDisplay display, EGLConfig config, EGLContext shared, const EGLint* attributes)
{
    static const auto real = original("eglCreateContext", epoxy_eglCreateContext);
    return std::getenv("AEOLIC_TEST_OLD") ? EGL_NO_CONTEXT : real(display, config, shared, attributes);
}

EGLBoolean initialize(EGLDisplay display, EGLint* major, EGLint* minor)
{
    static const auto real = original("eglInitialize", epoxy_eglInitialize);
    return std::getenv("AEOLIC_TEST_CLOSED") ? EGL_FALSE : real(display, major, minor);
}

std::mutex mutex;
// Every frame begins by clearing what its surface is drawn into, and sets fences afterwards. Samples of edges are drawn
// without that.
long surfacesDrawn = 0;
std::map<GLsync, long> drawnBefore;

void clearColor(GLuint framebuffer, GLenum buffer, GLint drawBuffer, const GLuint* value)
{
    static const auto real = original("glClearNamedFramebufferuiv", epoxy_glClearNamedFramebufferuiv);
    const std::lock_guard lock(mutex);
    ++surfacesDrawn;
    real(framebuffer, buffer, drawBuffer, value);
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
    epoxy_glGetInteger64v = integer64;
    epoxy_glGetIntegerv = integer;
    epoxy_glGetString = string;
    epoxy_glGetStringi = stringAt;
    epoxy_glGetUnsignedBytei_vEXT = identity;
    epoxy_eglQueryDeviceStringEXT = deviceString;
    epoxy_eglCreateContext = createContext;
    epoxy_eglInitialize = initialize;
    epoxy_glTextureStorage2D = textureStorage2D;
    epoxy_glClearNamedFramebufferuiv = clearColor;
    epoxy_glFenceSync = fenceSync;
    epoxy_glClientWaitSync = clientWaitSync;
}

}  // namespace
