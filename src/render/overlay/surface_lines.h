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
    /// An arrow's head, with its tip at `to`.
    struct Head {
        glm::vec3 from{0}, to{0};
    };
    /// What looks alike. Later styles lie over earlier ones.
    struct Style {
        StrokeLook look;
        std::vector<std::vector<glm::vec3>> lines;  ///< [lines][points]
        std::vector<Mark> marks;
        std::vector<Head> heads = {};
    };

    /// Points are world positions beside the surface's originWorld (SurfaceMesh).
    explicit SurfaceLines(std::vector<Style> styles) : styles_(std::move(styles)) {}

    /// Cost: O(points), and drawStrokes().
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override;

private:
    std::vector<Style> styles_;
};

/// Puts heads on a line, `apart` from each other and half of that from its beginning; one at least where the line is as
/// long.
void addHeads(const std::vector<glm::vec3>& line, double apart, SurfaceLines::Style& style);

}  // namespace aeolic
