#pragma once

#include "render/gl/device/copies.h"
#include "render/gl/device/frames_in_flight.h"
#include "render/gl/device/gl_blocks.h"
#include "render/gl/device/gpu_scene.h"
#include "render/gl/edges/edges.h"
#include "render/gl/lic/gl_lic_stage.h"
#include "render/gl/lic/guard_rows.h"
#include "render/gl/lic/near_tiles.h"
#include "render/gl/project/frame_images.h"
#include "render/gl/project/gl_resolve.h"
#include "render/gl/project/row_counts.h"
#include "render/gl/shade/gl_shade.h"

namespace aeolic::gl {

/// What lives in the context: destroyed while it is current. Rows are global.
struct GpuState {
    GpuState(const Scene& loaded, bool isProgram)
        : scene(loaded), view(sizeof(ViewBlock), GL_DYNAMIC_STORAGE_BIT), edges(isProgram)
    {
    }

    /// Which triangle shows in each pixel of `area`, and the view for all that follows.
    void draw(Programs& programs, const View& from, const Extent& area);

    /// Shaders get the view of the last draw().
    void bindView() const;

    /// Links of `drawn`, once the pixels of `neighbours` are there.
    void findLinks(Programs& programs, const View& from, const Extent& drawn, const Extent& neighbours);

    /// Collective. Of other ranks' rows beyond `compute` brings the vectors as far as traces sample them, the links as
    /// far as they go at all.
    void receiveFlow(Programs& programs, GuardExchange& guards, const Extent& compute, int sampled, int whole);

    GpuScene scene;
    Buffer view;
    CoverageCount coverage;
    FrameImages images;
    FramesInFlight frames;
    NearTiles near;
    BrickPixels bricks;
    DirectConvolution direct;
    HierarchicalConvolution hierarchical;
    AlongFlow along;
    Flatten flatten;
    GlPhases phases;
    Occlusion occlusion;
    Shade shade;
    Edges edges;
    RowFlowCopy facts;
    GuardRowExchange exchange;
};

}  // namespace aeolic::gl
