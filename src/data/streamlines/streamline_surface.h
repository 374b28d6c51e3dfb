#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "data/topology/surface_tracer.h"

namespace aeolic {

/// A surface and its flow, ready for streamlines along the flow and across it. Lengths that are not called world count
/// in a unit that is near the surface's size.
class StreamlineSurface {
public:
    /// `vectors`: [points of the mesh], in the world's axes; NaN where nothing flows. Cost: O(triangles), parallel.
    StreamlineSurface(SurfaceMesh mesh, std::vector<glm::vec3> vectors);
    StreamlineSurface(const StreamlineSurface&) = delete;

    const SurfaceTracer& along() const { return along_; }
    const SurfaceTracer& across() const { return across_; }

    /// Where a place is: world axes, beside the mesh's originWorld.
    glm::vec3 at(const SurfacePlace& place) const
    {
        return glm::vec3((positionWorld(mesh_, place) - mesh_.originWorld) / unitWorld_);
    }
    /// The normal of a triangle, unit length.
    glm::vec3 normal(std::uint32_t triangle) const;

    /// None of its corners is masked, and the flow does not rest at all of them.
    bool hasFlow(std::uint32_t triangle) const;
    double area() const { return areas_.empty() ? 0 : areas_.back(); }  ///< Of all that has flow.
    double size() const { return size_; }                               ///< The diagonal of its box.
    double unitWorld() const { return unitWorld_; }                     ///< A power of two.

    /// The place that is nearest to a point, of those nearest the one in the first triangle. There is a triangle.
    /// Cost: O(triangles), parallel (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
    SurfacePlace nearest(const glm::dvec3& pointWorld) const;

    /// The streamline through a place, downstream, in two parts: what comes to it, and what leaves it; at(). Empty
    /// where nothing flows. No part is longer than four times the surface's size.
    std::array<std::vector<glm::vec3>, 2> through(const SurfacePlace& place) const;

    /// The `which`-th of `count` places that are spread evenly over the area, in the order of the triangles.
    SurfacePlace spread(std::size_t which, std::size_t count) const;

private:
    SurfaceMesh mesh_;
    SurfaceFans fans_;
    TangentField flow_;
    SurfaceTracer along_, across_;
    std::vector<double> areas_;  // [triangles] Of all up to this one.
    double size_ = 0, unitWorld_ = 1;
};

}  // namespace aeolic
