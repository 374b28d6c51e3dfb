#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/streamlines/streamline_surface.h"

namespace aeolic {

/// A place on a streamline.
struct StreamlinePoint {
    glm::vec3 at{0};      ///< World axes, beside the surface's originWorld; in EvenStreamlines::unitWorld().
    glm::vec3 normal{0};  ///< The triangle's, unit length.
    float arc = 0;        ///< Along the line from its seed on, in the same unit; less than 0 upstream.
    SurfacePlace place;
};

/// A streamline, or what a finer level adds to one at an end. Points follow each other downstream.
struct EvenStreamline {
    int level = 0;
    std::uint32_t chain = 0;  ///< The same for a streamline and what is added to it.
    std::vector<StreamlinePoint> points;
};

/// An end of a line where another line was too near. With less spacing it may go on.
struct OpenEnd {
    std::uint32_t chain = 0;
    int direction = 1;  ///< 1: downstream.
    SurfacePlace place;
    float arc = 0;
};

/// Streamlines on a surface that keep about the same distance from each other (Jobard and Lefer, "Creating
/// evenly-spaced streamlines of arbitrary density", Visualization in Scientific Computing 1997), in levels: each has
/// half the spacing of the one before, keeps its lines, makes them longer and adds others (Jobard and Lefer,
/// "Multiresolution flow visualization", WSCG 2001). Where a line is never depends on the view. So lines stay on the
/// surface while the camera moves, and a picture chooses for each place the levels that it has room for.
///
/// Distances are measured through space, between places that face the same way. The lines do not depend on the number
/// of threads.
class EvenStreamlines {
public:
    /// `vectors`: [points of the mesh], in the world's axes; NaN where nothing flows. Cost: O(triangles), parallel.
    /// `levelWorld`: some level has this spacing, world units, where it is above 0.
    EvenStreamlines(SurfaceMesh mesh, std::vector<glm::vec3> vectors, double levelWorld = 0);

    /// Makes levels up to this one, as long as canRefine(). Cost: about that of the triangles which new lines pass, and
    /// of the samples of all lines, a quarter of the spacing apart.
    void refineTo(int level);

    /// The unit of lengths: a power of two, near the surface's size, which is the diagonal of the box of all that has
    /// flow. So nothing is too large or too small for floats.
    double unitWorld() const { return surface_.unitWorld(); }

    const StreamlineSurface& surface() const { return surface_; }

    /// In that unit. Level 0 has the spacing of a sixth of the surface's size, or the next to that.
    double spacing(int level) const;
    int levels() const { return levels_; }
    bool canRefine() const;
    const std::vector<EvenStreamline>& lines() const { return lines_; }  ///< In the order of their levels.

    /// Spread evenly over all of the surface that has flow; as StreamlinePoint::at.
    const std::vector<glm::vec3>& places() const { return places_; }

    /// The area may have so many squares of the spacing on the finest level: lines have about four samples on each.
    static constexpr double kMostSquares = 1 << 18;
    static constexpr int kMostLevels = 24;

private:
    const StreamlineSurface surface_;
    double coarsest_ = 0;  // The spacing of level 0.
    std::vector<glm::vec3> places_;
    std::vector<EvenStreamline> lines_;
    std::vector<OpenEnd> ends_;
    std::uint32_t chains_ = 0;
    int levels_ = 0;
};

}  // namespace aeolic
