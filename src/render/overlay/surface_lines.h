#pragma once

#include <utility>
#include <vector>

#include "render/overlay/strokes.h"

namespace aeolic {

/// Lines and marks on a surface, drawn over it with smooth edges where the surface does not hide them. Each has a
/// casing around it, so that it stands out from any colour.
class SurfaceLines final : public SurfaceOverlay {
public:
    struct Mark {
        glm::vec3 at{0};
        MarkShape shape = MarkShape::disc;
    };
    /// What looks alike. Later styles lie over earlier ones.
    struct Style {
        StrokeLook look;
        std::vector<std::vector<glm::vec3>> lines;  ///< [lines][points]
        std::vector<Mark> marks;
    };

    /// Points are world positions beside the surface's originWorld (SurfaceMesh).
    explicit SurfaceLines(std::vector<Style> styles) : styles_(std::move(styles)) {}

    /// Cost: O(points), and drawStrokes().
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override;

private:
    std::vector<Style> styles_;
};

}  // namespace aeolic
