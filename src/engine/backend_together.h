#pragma once

#include <memory>
#include <string>

#include "cluster/comm/communicator.h"
#include "engine/load_together.h"
#include "render/backend.h"

namespace aeolic {

/// What the ranks of a job draw with: all the same, or the seams would show.
struct BackendPlan {
    std::string name;       ///< cpu | gl; auto as long as nothing speaks against GPUs.
    bool realOnly = false;  ///< `auto`: not on a renderer that is a program.
    std::string unusedGpu;  ///< Why `auto` draws on processors; else empty.
    bool missed = false;    ///< … though a GPU is there, which might be expected to draw.
};

/// Collective. Before anything large is read: whether every rank has a device, and that room for its part of a scene
/// that is split so, at every step that its frames show, by the headers of its files. Of ranks that share a device each
/// gets its share of the memory.
/// Throws on all ranks InputError where one of them has not and the description says gl; under auto the plan is cpu.
BackendPlan planBackend(Communicator& communicator, const SceneDescription& description, const Split& split,
                        const GpuChoice& gpu);

/// Collective. The backend for a scene that is loaded; under auto cpu on all ranks where one of them cannot have gl,
/// and `plan` says so then. Throws as planBackend().
std::unique_ptr<Backend> makeBackend(Communicator& communicator, BackendPlan& plan, const Scene& scene,
                                     const GpuChoice& gpu);

/// Collective. The scene was changed in place, and `backend`, which is of `plan`, takes over what `change` says. false:
/// under auto a GPU cannot any more; `plan` is cpu, and a backend has to be made anew. Throws as planBackend().
bool moveBackend(Communicator& communicator, BackendPlan& plan, const SceneChange& change, Backend& backend);

}  // namespace aeolic
