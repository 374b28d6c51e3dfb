#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "render/gbuffer.h"
#include "render/tile.h"
#include "render/view.h"

namespace aeolic {

/// What the projection stage found in some rows, in this process's memory: for overlays that are drawn over the
/// surface, and for programs that ask what a pixel shows. Its images keep their memory from frame to frame.
class SeenSurface {
public:
    Image<float> invDepth, gradX, gradY;  ///< As GBuffer has them.
    Image<std::uint32_t> flow;            ///< flow_texel.
    float flowUnitPx = 1;                 ///< As GBuffer has it.

    const Extent& rows() const { return invDepth.valid(); }  ///< Global pixels.
    void resize(const Extent& rows)
    {
        invDepth.resize(rows), gradX.resize(rows), gradY.resize(rows);
        flow.resize(rows);
    }

    bool covered(int x, int y) const { return invDepth.at(x, y) > 0; }

    /// How far along the line of sight's axis the surface lies, in the world's units. The pixel is covered.
    double depth(const View& view, int x, int y) const { return view.unitWorld / double(invDepth.at(x, y)); }

    /// Of the facet that the pixel shows, towards the viewer, unit length, in the world's axes. The pixel is covered.
    glm::vec3 normal(const View& view, int x, int y) const
    {
        // 1 / depth is linear in the image. What it is in slopes is the facet's plane, seen from the eye.
        const float right = (float(x) + 0.5f - view.centerX) / view.focalPx,
                    down = (float(y) + 0.5f - view.centerY) / view.focalPx;
        const float alongRight = gradX.at(x, y) * view.focalPx, alongDown = gradY.at(x, y) * view.focalPx;
        const float ahead = invDepth.at(x, y) - alongRight * right - alongDown * down;
        return -glm::normalize(alongRight * view.right - alongDown * view.up + ahead * view.forward);
    }

    /// The way of one integration step, in pixels to the right and downwards; nothing where no streaks show.
    std::optional<glm::vec2> step(int x, int y) const
    {
        const std::uint32_t texel = flow.at(x, y);
        if (flow_texel::noise(texel) == 0) return std::nullopt;
        return glm::vec2(flow_texel::dx(texel), flow_texel::dy(texel)) * flowUnitPx;
    }
};

/// Something that is drawn over the finished surface, and under the figure: arrows, lines, marks.
class SurfaceOverlay {
public:
    virtual ~SurfaceOverlay() = default;

    /// Local. Draws over finished pixels of the rows seen, by Tile::put(). A pixel depends on the view and on the
    /// surface seen there alone, not on which other rows this rank has: else ranks would show.
    virtual void draw(const View& view, const SeenSurface& seen, Tile& out) const = 0;
};

}  // namespace aeolic
