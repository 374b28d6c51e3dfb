#pragma once

#include "base/extent.h"
#include "render/gl/device/objects.h"

namespace aeolic::gl {

/// What is kept of a frame on the GPU, between the stages and from frame to frame. Row 0 of the textures is the first
/// row held; visibility alone spans the whole image, so that the rasterizer computes in the same coordinates whatever
/// rows are drawn. Beyond the rows held lie zeros as far as a step and its taps reach.
struct FrameImages {
    /// Makes `valid` the rows that are held. Memory is taken only where the image's width or height changes, or more
    /// rows are held than ever. Throws InputError where the device has not enough.
    void resize(int width, int height, const Extent& valid, bool withScalar, bool withColors);
    /// Layers for so many levels of jumps, remainder included.
    void resizeJumps(int levels, bool withWeighted);

    /// Scalar and colours. Where there are none, something else of the kind: drivers complain of samplers without a
    /// texture, also where shaders do not get to them.
    void bindColors(GLuint scalarUnit, GLuint colorsUnit) const;

    Extent valid;

    Texture visible, depth;           ///< [whole] triangle + 1; near / depth.
    Framebuffer target;               ///< Draws into both.
    Texture surface;                  ///< invDepth, gradX, gradY, light where covered.
    Texture flow, links;              ///< What GBuffer says; links near flow alone.
    Texture scalar;                   ///< Where the scene has one.
    Texture colors;                   ///< GBuffer::colors
    Texture openFlow, wholeFlow;      ///< flow_cells.comp
    Texture lic;                      ///< Where there is flow.
    Texture words;                    ///< A pixel's value and links in one (along_flow.h), where there is flow.
    Texture places, metas, weighted;  ///< jumps.glsl, a layer a level and direction.

private:
    void clearBeyond() const;
    int rows_ = 0;
};

}  // namespace aeolic::gl
