#pragma once

#include <array>

#include "aeolic/scene_description.h"
#include "render/gl/device/beside_rows.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/lic/near_tiles.h"
#include "render/gl/project/frame_images.h"
#include "render/lic/jump_plan.h"
#include "render/lic/phase_mix.h"

namespace aeolic::gl {

class GuardRowExchange;

/// What both methods' programs read and write.
struct ConvolvePass {
    Programs& programs;
    const NearTiles& near;
    FrameImages& images;
    float flowUnitPx;
};

/// Writes what traces read (flow_cells.comp) in rows [y0, y1) of those held, near flow. `sharpness` 0: the noise as
/// it is.
void makeFlowCells(const ConvolvePass& pass, float sharpness, int y0, int y1);

/// Textures and uniforms of trace.glsl.
void bindTraces(const ConvolvePass& pass, GLuint program);

/// Uniforms of lic_value.glsl.
void setContrast(GLuint program, const LicOptions& lic);

/// The line integral of rows [y0, y1) of those held by stepping every pixel's streamline.
class DirectConvolution {
public:
    void run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1);

private:
    GrowingBuffer weights_{GL_DYNAMIC_STORAGE_BIT};
};

/// The line integral by composed jumps (render/cpu/lic/hierarchical.h says how). Without `guards` levels are computed
/// in all rows held; with them in [y0, y1) alone, and then received around it.
class HierarchicalConvolution {
public:
    void run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1, GuardRowExchange* guards);

private:
    void prepare(const ConvolvePass& pass, const LicOptions& lic);

    JumpPlan plan_;
    int plannedSteps_ = 0;
    Buffer block_;
    GrowingBuffer turns_{GL_DYNAMIC_STORAGE_BIT};
};

/// The second convolution (render/lic/along_flow.h) of rows [y0, y1) of those held.
class AlongFlow {
public:
    /// Collective with `beside`. `compute`: those rows, global. Values are right in `more` rows on each side, too.
    void run(const ConvolvePass& pass, const LicOptions& lic, const Extent& compute, RowExchange* beside, int more,
             StageTimers& timers);

    /// Collective. Brings the values of `rows` rows on each side, where there is no second convolution.
    void receiveValues(const ConvolvePass& pass, const Extent& compute, RowExchange& beside, int rows,
                       StageTimers& timers);

private:
    /// Local. Starts the way of the texels at the stripe's ends off the device, `rows` rows at each.
    void send(const FrameImages& images, const Texture& from, const Extent& compute, int rows);
    /// Collective. Waits for them, exchanges them, and starts the way of the others' onto the device.
    void receive(const FrameImages& images, const Texture& into, const Extent& compute, RowExchange& beside, int rows,
                 StageTimers& timers);
    /// Bytes from the beginning of `memory_` to row `y`, global.
    std::size_t placeOf(const FrameImages& images, int y) const;

    Extent around_;  // The rows in `memory_`: the stripe and those beside.
    SharedMemory memory_{true};
    Fence copied_;
};

/// The last step of even streaks (render/flatten.h).
class Flatten {
public:
    /// What Backend::flatten() does, rows global. `height`: the picture's.
    void run(Programs& programs, const FrameImages& images, const LicOptions& lic, int height, const Extent& compute,
             RowExchange* beside, int more, StageTimers& timers);

private:
    BesideRows words_;
    GrowingBuffer sums_{0};
};

/// The values that a cycle of phases is mixed from, on the device: a texture for each that is kept, as large as that of
/// the LIC stage's values.
class GlPhases {
public:
    void keep(int which, const FrameImages& images);

    /// What Backend::mixPhases() does, over all rows that are held.
    void mix(Programs& programs, const FrameImages& images, const phase_mix::Mixture& mixture,
             StageTimers& timers) const;

private:
    std::array<Texture, phase_mix::kMostKept> kept_;
};

}  // namespace aeolic::gl
