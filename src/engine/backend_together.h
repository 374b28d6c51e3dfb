#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cluster/comm/communicator.h"
#include "data/load/split.h"
#include "data/scene.h"
#include "render/backend_kinds.h"

namespace aeolic {

/// What the ranks of a job draw with. All draw with the same, or the seams would show.
struct BackendPlan {
    std::vector<const BackendKind*> kinds;  ///< The first draws. If it cannot, and there is another, that one does.
    DeviceRequest request;                  ///< What they are asked for.
    std::string unusedGpu;                  ///< Why auto draws on processors; else empty.
    bool missed = false;                    ///< A GPU is there that one might expect to draw, and it does not.

    const BackendKind& kind() const { return *kinds.front(); }
};

/// Collective. To be called before anything large is read: finds out whether every rank has a device, and whether that
/// has room for the rank's part of a scene that is split so, at every step that its frames show. It goes by the headers
/// of the files. Ranks that share a device share its memory.
/// Where one of them has no device or no room, all throw InputError if the description says gl; under auto the plan
/// goes on to the next kind.
BackendPlan planBackend(Communicator& communicator, const SceneDescription& description, const Split& split,
                        const GpuChoice& gpu);

/// Collective. The backend for a scene that is loaded. Under auto all ranks get the next kind where one of them cannot
/// have the plan's, and `plan` says so then. Throws what planBackend() throws.
std::unique_ptr<Backend> makeBackend(Communicator& communicator, BackendPlan& plan, const Scene& scene);

/// Collective. The scene was changed in place, and `backend`, made by `plan`, takes over what `change` says. False:
/// under auto a GPU has no room any more; `plan` is the next kind then, and a new backend has to be made. Throws what
/// planBackend() throws.
bool moveBackend(Communicator& communicator, BackendPlan& plan, const SceneChange& change, Backend& backend);

}  // namespace aeolic
