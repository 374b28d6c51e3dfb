#include "render/backend.h"

#include "aeolic/error.h"
#include "render/backend_choice.h"
#include "render/cpu/cpu_backend.h"
#include "render/gl/gl_backend.h"

namespace aeolic {

BackendChoice chooseBackend(const std::string& name, const Scene& scene, const GpuChoice& gpu)
{
    if (name == "gl") return {gl::makeGlBackend(scene, gpu, false), ""};
    std::string unused;
    if (name == "auto") {
        try {
            return {gl::makeGlBackend(scene, gpu, true), ""};
        } catch (const gl::NoGpu&) {
        } catch (const InputError& error) {  // An old driver, or a scene that does not fit.
            unused = error.what();
        }
    }
    return {cpu::makeCpuBackend(scene), unused};
}

std::unique_ptr<Backend> makeBackend(const std::string& name, const Scene& scene, const GpuChoice& gpu)
{
    return chooseBackend(name, scene, gpu).backend;
}

}  // namespace aeolic
