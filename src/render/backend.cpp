#include "render/backend.h"

#include "aeolic/error.h"
#include "render/cpu/cpu_backend.h"

namespace aeolic {

std::unique_ptr<Backend> makeBackend(const std::string& name, const Scene& scene, const GpuChoice&)
{
    if (name == "gl") throw InputError("--backend", "gl, which this build does not have", "auto or cpu");
    return cpu::makeCpuBackend(scene);
}

}  // namespace aeolic
