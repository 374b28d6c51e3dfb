#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace aeolic {

using Triangle = std::array<std::uint32_t, 3>;

/// Half-edge 3 t + i is the side of triangle t from its corner i to the next; corner 3 t + i is where it starts.
inline std::uint32_t nextInTriangle(std::uint32_t halfEdge)
{
    return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
}

/// For every half-edge the next one between the same two points, in either direction: the half-edges of an edge form a
/// ring in ascending order. A boundary edge is a ring of one, a manifold edge of two, anything more is not manifold.
/// Indices must be below `points`; at most 2^32 / 3 triangles, else std::length_error. Cost: O(triangles), parallel
/// sorts of a handful of entries each.
std::vector<std::uint32_t> ringEdges(const std::vector<Triangle>& triangles, std::size_t points);

/// [3 triangles] The angles at the corners, in radians. Those of a polygon's triangles add up to its own.
std::vector<double> cornerAngles(const std::vector<Triangle>& triangles, const std::vector<glm::vec3>& positions);

/// The triangles with one index for points in the same place, the first of them. Cost: a sort.
std::vector<Triangle> joinedTriangles(std::vector<Triangle> triangles, const std::vector<glm::vec3>& positions);

}  // namespace aeolic
