#pragma once

#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/programs.h"
#include "render/gl/project/frame_images.h"
#include "render/palette.h"
#include "render/view.h"

namespace aeolic::gl {

/// Anti-aliasing (render/antialias.h): visibility is drawn once for each sample, in edge pixels alone.
class Edges {
public:
    /// What edges are smoothed from. The view's and the palette's blocks are bound.
    struct Pass {
        Programs& programs;
        const GpuScene& scene;
        const View& view;
        const FrameImages& images;
        const Palette& palette;
    };

    /// Smooths the edges of rows `compute` in `pixels`, RGBA bytes of rows `shown`, all global. `open`: of
    /// the same rows, as Occlusion leaves it.
    void run(const Pass& pass, const Extent& compute, const Extent& shown, const Buffer& pixels, const Buffer& open);

private:
    void resize(const Pass& pass, const Extent& compute);
    void findEdges(const Pass& pass, const Extent& compute) const;
    /// Which triangle shows at a sample.
    void drawSample(const Pass& pass, const Extent& compute, int sample);

    Texture edges_;         // [rows held] 1 at edges.
    Texture seen_, depth_;  // [whole]
    Framebuffer target_;
    VertexArray none_;
    GrowingBuffer sums_{0};
};

}  // namespace aeolic::gl
