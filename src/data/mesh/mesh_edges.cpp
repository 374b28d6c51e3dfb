#include "data/mesh/mesh_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "base/parallel.h"

namespace aeolic {
namespace {

/// A half-edge in the bucket of its lower point.
struct EdgeEntry {
    std::uint32_t higherPoint, halfEdge;

    bool operator<(const EdgeEntry& other) const
    {
        return higherPoint != other.higherPoint ? higherPoint < other.higherPoint : halfEdge < other.halfEdge;
    }
};

/// Links every run of entries with the same higher point into a ring.
void linkBucket(EdgeEntry* begin, EdgeEntry* end, std::vector<std::uint32_t>& next)
{
    std::sort(begin, end);
    for (EdgeEntry* first = begin; first != end;) {
        EdgeEntry* last = first;
        while (last + 1 != end && last[1].higherPoint == first->higherPoint) {
            next[last->halfEdge] = last[1].halfEdge;
            ++last;
        }
        next[last->halfEdge] = first->halfEdge;
        first = last + 1;
    }
}

/// [points] The first of those in the same place, which may be the point itself.
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

}  // namespace

std::vector<std::uint32_t> ringEdges(const std::vector<Triangle>& triangles, std::size_t points)
{
    if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3) {
        throw std::length_error("a mesh of more than 2^32 / 3 triangles");
    }
    // A counting sort by the lower point: one bucket per point, a handful of half-edges in each.
    std::vector<std::uint32_t> bucketEnd(points + 1, 0);
    const auto forHalfEdges = [&](const auto& body) {
        std::uint32_t halfEdge = 0;
        for (const Triangle& t : triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [lower, higher] = std::minmax(t[i], t[i == 2 ? 0 : i + 1]);
                body(lower, EdgeEntry{higher, halfEdge++});
            }
        }
    };
    forHalfEdges([&](std::uint32_t lower, const EdgeEntry&) { ++bucketEnd[lower + 1]; });
    for (std::size_t p = 0; p < points; ++p) bucketEnd[p + 1] += bucketEnd[p];
    std::vector<EdgeEntry> entries(3 * triangles.size());
    // Filling moves each bucket's start to its end: afterwards bucket p is [bucketEnd[p - 1], bucketEnd[p]).
    forHalfEdges([&](std::uint32_t lower, const EdgeEntry& entry) { entries[bucketEnd[lower]++] = entry; });

    std::vector<std::uint32_t> next(entries.size());
    parallelRanges(points, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            linkBucket(entries.data() + (p == 0 ? 0 : bucketEnd[p - 1]), entries.data() + bucketEnd[p], next);
        }
    });
    return next;
}

std::vector<double> cornerAngles(const std::vector<Triangle>& triangles, const std::vector<glm::vec3>& positions)
{
    std::vector<double> angles(3 * triangles.size());
    parallelRanges(triangles.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto at = [&](std::size_t i) { return glm::dvec3(positions[triangles[t][i % 3]]); };
                const glm::dvec3 a = at(k + 1) - at(k), b = at(k + 2) - at(k);
                angles[3 * t + k] = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            }
    });
    return angles;
}

std::vector<Triangle> joinedTriangles(std::vector<Triangle> triangles, const std::vector<glm::vec3>& positions)
{
    const std::vector<std::uint32_t> first = firstsOfPlaces(positions);
    for (Triangle& triangle : triangles)
        for (std::uint32_t& point : triangle) point = first[point];
    return triangles;
}

}  // namespace aeolic
