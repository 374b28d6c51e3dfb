#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/surface_overlay.h"

namespace aeolic {

/// A mark at a point of the surface.
enum class MarkShape { disc, ring, ringWithDot, cross };

/// Lines and marks on a surface, drawn over it with smooth edges where the surface does not hide them. Each has a
/// casing around it, so that it stands out from any colour.
class SurfaceLines final : public SurfaceOverlay {
public:
    struct Mark {
        glm::vec3 at{0};
        MarkShape shape = MarkShape::disc;
    };
    /// Sizes are those in a picture of 800x800 pixels. They grow with the picture as text does.
    struct Look {
        std::array<std::uint8_t, 3> color{}, casing{};
        float widthPx = 2, casingPx = 1.5f;  ///< The casing's is added on either side.
        float markPx = 10;                   ///< A mark's diameter, without its casing.
    };
    /// What looks alike. Where things of one style overlap they are drawn as one. Later styles lie over earlier ones.
    struct Style {
        Look look;
        std::vector<std::vector<glm::vec3>> lines;  ///< [lines][points]
        std::vector<Mark> marks;
    };

    /// Points are world positions beside the surface's originWorld (SurfaceMesh).
    explicit SurfaceLines(std::vector<Style> styles) : styles_(std::move(styles)) {}

    /// Cost: that of the pixels near lines and marks, parallel; and a look at each segment for every 16 rows.
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override;

private:
    std::vector<Style> styles_;
};

}  // namespace aeolic
