#pragma once

#include "aeolic/renderer.h"
#include "pipeline/frame_group.h"
#include "render/backend.h"

namespace aeolic {

/// One frame's request: everything that may change between frames of a scene.
struct FrameRequest {
    Camera camera;
    LicOptions lic;
    ShadingOptions shading;
};

/// Collective. Draws one frame into `tiles`: the paper's figure as code. Fills `stats` with the stages' times.
void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group,
                 FrameTiles& tiles, FrameStats& stats);

}  // namespace aeolic
