#pragma once

#include "base/extent.h"
#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/objects.h"

namespace aeolic::gl {

/// Where the rasterizer draws: a number for each pixel, and its depth. Throws std::runtime_error where the driver
/// cannot.
Framebuffer makeTarget(const Texture& ids, const Texture& depth);

struct RasterPass {
    GLuint program = 0, target = 0;
    int width = 0, height = 0;  ///< The picture's.
    Extent area{};              ///< The part of it that is drawn.
    float farthest = 0;         ///< What the depth is cleared to; nearer is more.
    bool frontFacesOnly = false;
};

/// Draws the scene's triangles, of which the nearest stay. Front faces count as nearer by what corners on whole
/// sub-pixels and rounding make planes differ (frontBias()).
void rasterize(const GpuScene& scene, const RasterPass& pass);

}  // namespace aeolic::gl
