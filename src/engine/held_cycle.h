#pragma once

#include <optional>
#include <string>

#include "description/camera.h"
#include "engine/frame_plan.h"
#include "render/palette.h"

namespace aeolic {

/// What of a cycle of phases the backend holds (render/lic/phase_mix.h): for as long as nothing but the phase and the
/// colours change, frames are mixed from it. All ranks hold the same.
class HeldCycle {
public:
    /// Whether a frame with this camera and these options, as the LIC stage gets them, goes on with it.
    bool holds(const Camera& camera, const LicOptions& lic, const Palette& palette) const;

    /// The backend holds this frame from now on.
    void hold(const Camera& camera, const LicOptions& lic, const Palette& palette, const FramePlan& plan);

    /// The backend is used for something else, or the scene changed.
    void forget() { frame_.reset(); }

    /// The plan by which the frame was drawn that the backend holds.
    const FramePlan& plan() const { return frame_->plan; }

private:
    struct Held {
        Camera camera;
        std::string lic;  // All options but the phase, as text.
        bool antialias, occlusion;
        FramePlan plan;
    };
    std::optional<Held> frame_;
};

}  // namespace aeolic
