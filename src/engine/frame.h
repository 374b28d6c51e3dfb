#pragma once

#include "aeolic/renderer.h"
#include "engine/frame_group.h"
#include "render/backend.h"
#include "render/palette.h"

namespace aeolic {

/// A request for a frame: everything that may change between frames of a scene.
struct FrameRequest {
    Camera camera;
    LicOptions lic;
    ShadingOptions shading;
    std::shared_ptr<const ColorMap> colorMap = nullptr;  ///< What `shading.colormap` names; null: it is built in.
    std::vector<std::shared_ptr<const ColorMap>> colorMaps = {};  ///< [Scene::colors] Of several surfaces.
    std::shared_ptr<const SurfaceOverlay> overlay = nullptr;      ///< Drawn over the surface; null: nothing is.
    /// Frames beside this one differ in the phase alone: it is mixed from values that are kept (phase_mix.h).
    bool inCycle = false;
};

/// Local. The colours it asks for.
Palette paletteOf(const FrameRequest& request, const Scene& scene);

/// One frame from its start to its end. Its memory is kept for frames after it: in an animation none allocates.
struct Frame {
    FramePlan plan;
    FrameTiles tiles;
    /// What is drawn over the surface at the end, and by what.
    struct Over {
        std::shared_ptr<const SurfaceOverlay> overlay;
        View view;
        SeenSurface seen;
    } over;
    FrameStats stats;
    RankStats mine;
};

/// Collective. Starts drawing one frame: the paper's figure as code. As many frames may be started before the first is
/// finished as the backend has in flight. `frame` must stay where it is until it is finished.
void startFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame);

/// Collective. Waits for the oldest frame started, which is `frame`: its pixels are in `tiles`, its times in `stats`.
void finishFrame(Backend& backend, FrameGroup& group, Frame& frame);

/// Collective. Starts and finishes a frame.
void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame);

}  // namespace aeolic
