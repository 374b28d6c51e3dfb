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

/// The picture's pixels, and memory kept from frame to frame: in an animation no frame allocates.
struct FrameTiles {
    Tile stripe;   ///< This rank's; on rank 0 not used.
    Tile picture;  ///< The whole; on rank 0 alone.
};

/// Collective. Draws one frame into `tiles.picture`: the paper's figure as code. Fills `stats` with the stages' times.
void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group,
                 FrameTiles& tiles, FrameStats& stats);

}  // namespace aeolic
