#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// A place on a surface: in a triangle, by the weights of its corners, which are at least 0 and have the sum 1.
struct SurfacePlace {
    std::uint32_t triangle = 0;
    glm::dvec3 weight{0};
};

/// Makes weights that are nearly those of a place in the triangle such: none is negative, and their sum is 1.
inline glm::dvec3 insideTriangle(glm::dvec3 weight)
{
    weight = glm::max(weight, glm::dvec3(0));
    return weight / (weight.x + weight.y + weight.z);
}

/// Along the triangle's normal, and twice as long as its area is large.
inline glm::dvec3 areaVector(const SurfaceMesh& mesh, std::uint32_t triangle)
{
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.triangles[triangle][i]]); };
    return glm::cross(at(1) - at(0), at(2) - at(0));
}

inline glm::dvec3 positionWorld(const SurfaceMesh& mesh, const SurfacePlace& place)
{
    const auto& corners = mesh.triangles[place.triangle];
    glm::dvec3 sum = mesh.originWorld;
    for (int i = 0; i < 3; ++i) sum += place.weight[i] * glm::dvec3(mesh.positions[corners[std::size_t(i)]]);
    return sum;
}

/// The length of the line through these places.
inline double lengthWorld(const SurfaceMesh& mesh, const std::vector<SurfacePlace>& places)
{
    double length = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        length += glm::length(positionWorld(mesh, places[i]) - positionWorld(mesh, places[i - 1]));
    return length;
}

}  // namespace aeolic
