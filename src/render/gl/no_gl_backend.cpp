#include "aeolic/error.h"
#include "render/gl/gl_backend.h"

/// For builds without OpenGL (AEOLIC_GL=OFF).
namespace aeolic::gl {

std::unique_ptr<Backend> makeGlBackend(const Scene&, const GpuChoice&, bool)
{
    throw NoGpu("--backend", "gl, which this build does not have", "auto or cpu");
}

std::string deviceIdentity(const GpuChoice&, bool)
{
    throw NoGpu("--backend", "gl, which this build does not have", "auto or cpu");
}

void requireRoom(const std::vector<SceneSizes>&, const GpuChoice&, bool, int)
{
    throw NoGpu("--backend", "gl, which this build does not have", "auto or cpu");
}

}  // namespace aeolic::gl
