#include "engine/held_cycle.h"

#include "description/option_table.h"
#include "description/scene_text.h"

namespace aeolic {
namespace {

/// The options without the phase.
std::string textOf(const LicOptions& lic)
{
    SceneDescription scene;
    scene.lic = lic;
    scene.lic.phase = 0;
    return groupText(scene, options::lic.key);
}

}  // namespace

bool HeldCycle::holds(const Camera& camera, const LicOptions& lic, const Palette& palette) const
{
    return frame_ && frame_->camera == camera && frame_->lic == textOf(lic) && frame_->antialias == palette.antialias &&
           frame_->occlusion == palette.occlusion;
}

void HeldCycle::hold(const Camera& camera, const LicOptions& lic, const Palette& palette, const FramePlan& plan)
{
    frame_ = {camera, textOf(lic), palette.antialias, palette.occlusion, plan};
}

}  // namespace aeolic
