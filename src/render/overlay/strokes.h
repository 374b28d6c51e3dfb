#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/surface_overlay.h"

namespace aeolic {

/// A mark at a point of the surface; `head` is an arrow's, along a line.
enum class MarkShape { disc, ring, ringWithDot, cross, head };

/// How lines and marks look. Sizes are those in a picture of 800x800 pixels. They grow with the picture as text does.
struct StrokeLook {
    std::array<std::uint8_t, 3> color{}, casing{};
    float widthPx = 2, casingPx = 1.5f;  ///< The casing's is added on either side.
    float markPx = 10;                   ///< A mark's diameter, or a head's length, without its casing.
    float casingPart = 1;                ///< How much of what lies under the casing it hides, [0, 1].

    /// At the size that it has in a picture.
    StrokeLook in(const Camera& camera) const;
};

/// What a look's sizes are multiplied by in a picture.
float strokeScale(const Camera& camera);

/// A point of the image, and what lies there.
struct StrokeEnd {
    glm::vec2 px{0};
    float invDepth = 0;
    float part = 1;  ///< How much shows of what is drawn: it gets thinner and paler, down to nothing at 0.
};

/// Something drawn on the surface: a straight way in the world, or a mark. A mark's two ends are the same, but for a
/// head, which points from the first to the second.
struct Stroke {
    StrokeEnd a, b;
    std::optional<MarkShape> mark;
    /// Of the surface that it lies on, towards the viewer or away; world axes. A stroke that has one shows only where a
    /// surface shows that faces about the same way: nothing of it is beside the silhouette, or comes around it.
    glm::vec3 normal{0};
};

/// What looks alike. Where strokes of one layer overlap they are drawn as one.
struct StrokeLayer {
    StrokeLook look;  ///< At the picture's own size.
    std::vector<Stroke> strokes;
};

/// A point in the eye's axes, in kernels' units: to the right, down and ahead. `point`: world axes, beside the
/// surface's originWorld, in units of `unitWorld`.
inline glm::vec3 fromEye(const View& view, const glm::vec3& point, double unitWorld = 1)
{
    const glm::vec3 way = point * float(unitWorld / view.unitWorld) - view.eyeLocal;
    return {glm::dot(way, view.right), -glm::dot(way, view.up), glm::dot(way, view.forward)};
}

/// Where the image shows a point before the eye.
StrokeEnd strokeEnd(const View& view, const glm::vec3& fromEye, float part = 1);

/// The part of a segment that is before the eye and in the picture, or no more than a picture beside it. The ends are
/// as fromEye() tells.
std::optional<Stroke> strokeOf(const View& view, glm::vec3 a, glm::vec3 b, float partA = 1, float partB = 1);

/// Draws layers over finished pixels of the rows seen, with smooth edges, where the surface does not hide them. Later
/// layers lie over earlier ones. Cost: that of the pixels near the strokes; parallel. A pixel depends on no other.
void drawStrokes(const View& view, const std::vector<StrokeLayer>& layers, const SeenSurface& seen, Tile& out);

}  // namespace aeolic
