#pragma once

#include "base/extent.h"
#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/programs.h"
#include "render/view.h"

namespace aeolic::gl {

/// Where the rasterizer draws: a number for each pixel, and its depth. Throws std::runtime_error where the driver
/// cannot.
Framebuffer makeTarget(const Texture& ids, const Texture& depth);

/// Draws which triangle is seen in each pixel of `area` (global pixels) into `target`, which spans the view's image:
/// the viewport is the whole image's whatever the area, and the area a scissor. The bound view block is `view`'s. Of
/// the scene's triangles the nearest stay. Front faces count as nearer by what corners on whole sub-pixels and rounding
/// make planes differ (frontBias()).
void drawVisibility(Programs& programs, const GpuScene& scene, const View& view, GLuint target, const Extent& area);

}  // namespace aeolic::gl
