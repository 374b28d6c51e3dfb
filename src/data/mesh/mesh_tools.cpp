#include "data/mesh/mesh_tools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr double minHeightPerEdge = 1e-7;
constexpr std::size_t triangleGrain = 4096;

bool isDegenerate(const SurfaceMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
    const auto [a, b, c] = triangle;
    if (a == b || b == c || c == a || std::max({a, b, c}) >= mesh.positions.size()) return true;
    const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const glm::dvec3 pq = q - p, qr = r - q, rp = p - r;
    const double longestSquared = std::max({glm::dot(pq, pq), glm::dot(qr, qr), glm::dot(rp, rp)});
    const double doubleArea = glm::length(glm::cross(pq, rp));
    // Written so that a NaN or an infinity, which makes the comparison false, counts as degenerate.
    return !(std::isfinite(longestSquared) && doubleArea > minHeightPerEdge * longestSquared);
}

/// Moves the kept elements to the front, in place; an empty array stays empty.
template <class T>
void keepOnly(std::vector<T>& values, const std::vector<std::uint8_t>& drop)
{
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!drop[i]) values[kept++] = values[i];
    values.resize(kept);
}

}  // namespace

std::size_t dropDegenerateTriangles(SurfaceMesh& mesh)
{
    std::vector<std::uint8_t> drop(mesh.triangles.size());
    parallelRanges(drop.size(), triangleGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) drop[i] = isDegenerate(mesh, mesh.triangles[i]);
    });
    const auto dropped = std::size_t(std::count(drop.begin(), drop.end(), 1));
    if (dropped == 0) return 0;
    keepOnly(mesh.triangles, drop);
    keepOnly(mesh.cellVectors, drop);
    keepOnly(mesh.cellScalars, drop);
    keepOnly(mesh.order, drop);
    return dropped;
}

double radiusAbout(const SurfaceMesh& mesh, const glm::dvec3& centerWorld)
{
    double squared = 0;
    const glm::dvec3 center = centerWorld - mesh.originWorld;
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 r = glm::dvec3(p) - center;
        squared = std::max(squared, glm::dot(r, r));
    }
    return std::sqrt(squared);
}

}  // namespace aeolic
