#pragma once

#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/programs.h"
#include "render/gl/project/frame_images.h"
#include "render/palette.h"
#include "render/view.h"

namespace aeolic::gl {

/// Anti-aliasing (render/antialias.h), as processors do it: the triangles near edge pixels are drawn into the samples
/// of these pixels, by programs and not by the rasterizer. The device alone knows how many pixels and triangles these
/// are.
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

    /// `isProgram`: the device is a program, for which more invocations are only more work.
    explicit Edges(bool isProgram);

    /// Smooths the edges of rows `compute` in `pixels`, RGBA bytes of rows `shown`, all global. `open`: of
    /// the same rows, as Occlusion leaves it.
    void run(const Pass& pass, const Extent& compute, const Extent& shown, const Buffer& pixels, const Buffer& open);

private:
    void reserve(const Pass& pass, const Extent& compute);
    void findEdges(const Pass& pass, const Extent& compute) const;
    void listTriangles(const Pass& pass, const Extent& compute) const;
    /// Which triangle shows at each sample of the edge pixels whose number is `first` or one of the held_ from there.
    void drawSamples(const Pass& pass, const Extent& compute, std::size_t first) const;
    /// The mean colours of these pixels.
    void findColors(const Pass& pass, const Extent& shown, const Buffer& pixels, const Buffer& open,
                    std::size_t first) const;

    int lanes_, mostSmallPx_;  // Invocations that share a small triangle, and how high and wide it is at most.
    unsigned listGroups_;   // Of programs over lists, whose length only the device knows: each goes through its share.
    Buffer noEdges_;        // How an EdgeList begins.
    std::size_t mostHeld_;  // The samples of so many pixels fit a buffer of the device.
    std::size_t held_ = 0;  // There is room for the samples of so many pixels.
    GrowingBuffer blocks_{0};   // edge_blocks.glsl
    GrowingBuffer list_{0};     // edge_list.glsl
    GrowingBuffer near_{0};     // Numbers of triangles: edge_near.comp.
    GrowingBuffer samples_{0};  // edge_samples.glsl
};

}  // namespace aeolic::gl
