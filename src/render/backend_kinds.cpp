#include "render/backend_kinds.h"

#include <stdexcept>

#include "description/option_table.h"
#include "render/cpu/cpu_backend.h"
#ifdef AEOLIC_WITH_GL
#include "render/gl/gl_backend.h"
#endif

namespace aeolic {
namespace {

/// In the order in which auto tries them.
const std::vector<const BackendKind*>& allKinds()
{
    static const std::vector<const BackendKind*> all{
#ifdef AEOLIC_WITH_GL
        &gl::kind,
#endif
        &cpu::kind,
    };
    return all;
}

}  // namespace

std::vector<const BackendKind*> kindsOf(BackendChoice choice)
{
    if (choice == BackendChoice::automatic) return allKinds();
    for (const BackendKind* kind : allKinds())
        if (kind->choice == choice) return {kind};
    throw InputError("--backend", std::string(nameOf(choice)) + ", which this build does not have", "auto or cpu");
}

std::unique_ptr<Backend> makeBackend(BackendChoice choice, const Scene& scene, const GpuChoice& gpu)
{
    const DeviceRequest request{gpu, choice == BackendChoice::automatic};
    const std::vector<const BackendKind*> kinds = kindsOf(choice);
    for (const BackendKind* kind : kinds) {
        const bool isLast = kind == kinds.back();
        if (!isLast && scene.inPieces && !kind->drawsPieces) continue;
        try {
            return kind->make(scene, request);
        } catch (const InputError&) {  // No device, an old driver, or a scene that does not fit.
            if (isLast) throw;
        }
    }
    throw std::logic_error("there is no kind of backend");
}

}  // namespace aeolic
