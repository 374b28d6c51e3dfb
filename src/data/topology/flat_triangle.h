#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "data/topology/tangent_field.h"

namespace aeolic {

/// A triangle laid flat: its first point is the origin, its second lies on the x axis, it turns counterclockwise. The
/// flow at its corners differs from that in the fans by how curved these are, or is the vectors' own along it.
struct FlatTriangle {
    std::array<glm::dvec2, 3> point, flow;

    FlatTriangle(const FlowSurface& surface, std::uint32_t triangle);

    /// With the flow turned by a quarter, counterclockwise.
    FlatTriangle turned() const;

    glm::dvec2 at(const glm::dvec3& weight) const
    {
        return weight.x * point[0] + weight.y * point[1] + weight.z * point[2];
    }
    glm::dvec2 flowAt(const glm::dvec3& weight) const
    {
        return weight.x * flow[0] + weight.y * flow[1] + weight.z * flow[2];
    }
    /// The weights of a place in the plane. Outside of the triangle some are below 0.
    glm::dvec3 weightsOf(const glm::dvec2& place) const;
    /// By how much the weights change on a way in the plane; their sum is 0.
    glm::dvec3 weightChange(const glm::dvec2& way) const
    {
        const glm::dvec2 others = perPlace_ * way;
        return {-others.x - others.y, others.x, others.y};
    }
    /// The flow's derivative.
    glm::dmat2 derivative() const;

private:
    glm::dmat2 perPlace_;  // What the weights of the second and third corner change by.
};

}  // namespace aeolic
