#pragma once

#include "aeolic/scene_description.h"
#include "render/gl/device/programs.h"
#include "render/gl/lic/near_tiles.h"
#include "render/gl/project/frame_images.h"
#include "render/jump_plan.h"

namespace aeolic::gl {

class GuardRowExchange;

/// What both methods' programs read and write.
struct ConvolvePass {
    Programs& programs;
    const NearTiles& near;
    FrameImages& images;
    float flowUnitPx;
};

/// Writes what traces read (trace_texels.comp) in rows [y0, y1) of those held, near flow. `sharpness` 0: the noise as
/// it is.
void makeTraceTexels(const ConvolvePass& pass, float sharpness, int y0, int y1);

/// The line integral of rows [y0, y1) of those held by stepping every pixel's streamline.
class DirectConvolution {
public:
    void run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1);

private:
    GrowingBuffer weights_{GL_DYNAMIC_STORAGE_BIT};
};

/// … by composed jumps (render/cpu/hierarchical_pass.h says how). Without `guards` levels are computed in all rows
/// held; with them in [y0, y1) alone, and then received around it.
class HierarchicalConvolution {
public:
    void run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1, GuardRowExchange* guards);

private:
    void prepare(const ConvolvePass& pass, const LicOptions& lic);

    JumpPlan plan_;
    int plannedSteps_ = 0;
    Buffer block_;
    GrowingBuffer rotations_{GL_DYNAMIC_STORAGE_BIT};
};

}  // namespace aeolic::gl
