#pragma once

#include "render/backend.h"

namespace aeolic {

/// A backend, and what came of looking for a GPU.
struct BackendChoice {
    std::unique_ptr<Backend> backend;
    std::string unusedGpu;  ///< Why `auto` leaves a GPU alone that is there; empty where none is, or it draws.
};

/// makeBackend(), telling more.
BackendChoice chooseBackend(const std::string& name, const Scene& scene, const GpuChoice& gpu);

}  // namespace aeolic
