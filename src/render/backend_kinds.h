#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/scene_sizes.h"
#include "render/backend.h"

namespace aeolic {

/// There is no device of a kind at all, or nothing to reach one by.
struct NoDevice : InputError {
    using InputError::InputError;
};

/// On what a backend is to draw.
struct DeviceRequest {
    GpuChoice gpu;
    bool realOnly = false;  ///< Not on a renderer that is a program.
};

/// A way to draw that this build has. A new one is a folder beside render/cpu/ and render/gl/ with such a row, which
/// backend_kinds.cpp lists.
struct BackendKind {
    BackendChoice choice;
    bool drawsPieces;  ///< Surfaces that are split among the ranks, too.

    /// Local. What tells the device that is asked for apart from the others of its host; empty where its driver does
    /// not say. Throws InputError for one that is not to be had, NoDevice where there is none. Null: it draws on no
    /// device that can be missing, or that ranks share.
    std::string (*identity)(const DeviceRequest& request);

    /// Local. Throws InputError where a scene does not fit the device, which `ranks` with as much to load are about to
    /// draw on, and says how many ranks would be enough. `steps`: its sizes, one after the other, at the moments it is
    /// shown at. Null with `identity`.
    void (*requireRoom)(const std::vector<SceneSizes>& steps, const DeviceRequest& request, int ranks);

    /// Local. Throws as identity() does, and where the scene does not fit.
    std::unique_ptr<Backend> (*make)(const Scene& scene, const DeviceRequest& request);

    bool needsDevice() const { return identity != nullptr; }
};

/// The kinds that `choice` allows: one of them, or under auto all, in the order in which they are tried. The last one
/// under auto needs no device. Throws InputError for a kind that this build does not have.
std::vector<const BackendKind*> kindsOf(BackendChoice choice);

}  // namespace aeolic
