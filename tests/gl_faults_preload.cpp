#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

/// Preloaded (LD_PRELOAD), makes a device fail in any program that draws by libepoxy:
/// AEOLIC_TEST_RESET=FILE     it was reset, as long as FILE exists
/// AEOLIC_TEST_MEMORY=BYTES   it has no memory for any texture of more
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

__attribute__((constructor)) void install()
{
    epoxy_glGetGraphicsResetStatus = resetStatus;
    epoxy_glGetError = error;
    epoxy_glTextureStorage2D = textureStorage2D;
}

}  // namespace
