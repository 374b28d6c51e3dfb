#include "data/mesh/mesh_edges.h"

#include <algorithm>
#include <limits>
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

}  // namespace aeolic
