#include "render/backend.h"

#include <stdexcept>

#include "aeolic/error.h"
#include "render/backend_choice.h"
#include "render/cpu/cpu_backend.h"
#include "render/gl/gl_backend.h"

namespace aeolic {

const SurfacePixels& Backend::projectPiece(const View&)
{
    throw std::logic_error("this backend draws no pieces");
}

GBuffer& Backend::surfaceRows(const View&, const Extent&)
{
    throw std::logic_error("this backend draws no pieces");
}

BackendChoice chooseBackend(const std::string& name, const Scene& scene, const GpuChoice& gpu)
{
    if (name == "gl" && scene.inPieces)
        throw InputError("--backend", "gl, but a surface in pieces is drawn by processors alone",
                         "cpu or auto, or --bricks off");
    if (name == "gl") return {gl::makeGlBackend(scene, gpu, false), ""};
    std::string unused;
    if (name == "auto" && !scene.inPieces) {
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
