#include "render/backend.h"

#include "aeolic/error.h"
#include "render/cpu/cpu_backend.h"
#include "render/gl/gl_backend.h"

namespace aeolic {

std::unique_ptr<Backend> makeBackend(const std::string& name, const Scene& scene, const GpuChoice& gpu)
{
    if (name == "gl") return gl::makeGlBackend(scene, gpu, false);
    if (name == "auto" && !scene.inPieces) {
        try {
            return gl::makeGlBackend(scene, gpu, true);
        } catch (const InputError&) {  // No GPU, an old driver, or a scene that does not fit.
        }
    }
    return cpu::makeCpuBackend(scene);
}

}  // namespace aeolic
