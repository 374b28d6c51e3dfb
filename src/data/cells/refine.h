#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// The largest number of triangles that refinement makes of a surface of `triangles`, in a field of `cells`. One that
/// has more keeps what it has. A cell in the surface's way needs a few, and makes few of a triangle that is smaller.
/// Damaged ones, of wild sizes or in each other, would need millions.
constexpr std::uint64_t mostRefinedTriangles(std::uint64_t cells, std::uint64_t triangles)
{
    constexpr std::uint64_t most = std::uint64_t{16} << 20, soon = std::uint64_t{1} << 16;
    constexpr std::uint64_t perCell = 256, perTriangle = 8;
    if (cells > most / perCell || triangles > most / perTriangle) return most;
    return std::clamp(perCell * cells + perTriangle * triangles, soon, most);
}

/// Rounds of halving: an edge is cut into at most 2^12 parts.
inline constexpr int kMostRefinements = 12;

/// Which edges of a mesh are to be cut in the middle.
struct EdgeCuts {
    std::vector<std::uint32_t> middle;  ///< [3 triangles] The new point on each half-edge, or kUncut.
    std::vector<glm::uvec2> ends;       ///< [new points] The lower end first.
    std::uint64_t triangles = 0;        ///< How many there will be.
    static constexpr std::uint32_t kUncut = 0xFFFFFFFF;
};

/// Asks of every edge whether it is to be cut: `tooLong(a, b)`, in world coordinates, called from several threads. The
/// answer must not depend on which end is `a`. Two triangles on an edge cut it alike, and so do two pieces of a
/// surface.
EdgeCuts findCuts(const SurfaceMesh& mesh, const std::function<bool(const glm::dvec3&, const glm::dvec3&)>& tooLong);

/// Cuts edges in the middle, and triangles into two, three or four. The surface stays where it is. Values on points are
/// interpolated, normals too; values of triangles and their order are those of the triangle that was cut.
void cutEdges(SurfaceMesh& mesh, const EdgeCuts& cuts);

}  // namespace aeolic
