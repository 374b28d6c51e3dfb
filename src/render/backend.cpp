#include "render/backend.h"

#include "aeolic/error.h"
#include "render/cpu/cpu_backend.h"
#include "render/gl/gl_backend.h"

namespace aeolic {

std::unique_ptr<Backend> makeBackend(BackendChoice choice, const Scene& scene, const GpuChoice& gpu)
{
    if (choice == BackendChoice::gl) return gl::makeGlBackend(scene, gpu, false);
    if (choice == BackendChoice::automatic && !scene.inPieces) {
        try {
            return gl::makeGlBackend(scene, gpu, true);
        } catch (const InputError&) {  // No GPU, an old driver, or a scene that does not fit.
        }
    }
    return cpu::makeCpuBackend(scene);
}

}  // namespace aeolic
