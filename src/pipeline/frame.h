#pragma once

#include "aeolic/renderer.h"
#include "render/backend.h"

namespace aeolic {

/// One frame's request: everything that may change between frames of a scene.
struct FrameRequest {
    Camera camera;
    LicOptions lic;
    ShadingOptions shading;
};

/// Draws one frame: the paper's figure as code. Fills `stats` with the stages' times. `reuse` gives an earlier frame's
/// memory back: in an animation no frame allocates.
Tile renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameStats& stats, Tile reuse = {});

}  // namespace aeolic
