#pragma once

#include <cstdint>
#include <vector>

#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/programs.h"
#include "render/gl/project/frame_images.h"
#include "render/gl/project/row_counts.h"
#include "render/view.h"

namespace aeolic::gl {

/// Draws which triangle is seen in each pixel of `area` (global pixels) into `target`, which spans the view's image:
/// the viewport is the whole image's whatever the area, and the area a scissor. The bound view block is `view`'s.
void drawVisibility(Programs& programs, const GpuScene& scene, const View& view, GLuint target, const Extent& area);

/// Counts the covered pixels of each row at a lower resolution.
class CoverageCount {
public:
    std::vector<std::int64_t> count(Programs& programs, const GpuScene& scene, const View& view);

private:
    Buffer block_;
    Texture ids_, depth_;
    Framebuffer target_;
    RowCounts counts_;
};

}  // namespace aeolic::gl
