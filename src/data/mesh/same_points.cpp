#include "data/mesh/same_points.h"

#include <algorithm>
#include <numeric>

namespace aeolic {

std::vector<std::uint32_t> firstsOfPlaces(const std::vector<glm::vec3>& positions)
{
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 &p = positions[a], &q = positions[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        if (p.z != q.z) return p.z < q.z;
        return a < b;
    };
    std::vector<std::uint32_t> sorted(positions.size()), first(positions.size());
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::sort(sorted.begin(), sorted.end(), before);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const bool again = i > 0 && positions[sorted[i]] == positions[sorted[i - 1]];
        first[sorted[i]] = again ? first[sorted[i - 1]] : sorted[i];
    }
    return first;
}

std::vector<Triangle> joinedTriangles(const SurfaceMesh& mesh)
{
    const std::vector<std::uint32_t> first = firstsOfPlaces(mesh.positions);
    std::vector<Triangle> triangles = mesh.triangles;
    for (Triangle& triangle : triangles)
        for (std::uint32_t& point : triangle) point = first[point];
    return triangles;
}

}  // namespace aeolic
