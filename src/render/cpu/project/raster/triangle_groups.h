#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/extent.h"
#include "data/mesh/surface_mesh.h"
#include "render/view.h"

namespace aeolic::cpu {

inline constexpr std::size_t kGroupTriangles = 64;  // Neighbours mostly, in files and in our own surfaces.
inline constexpr std::size_t kBlockPoints = 256;    // Whole vectors of every target.

/// So many triangles as follow each other in a mesh: all within a box, their points within some blocks.
struct TriangleGroup {
    glm::vec3 loLocal, hiLocal;
    std::uint32_t firstBlock, lastBlock;
};

/// Local. The groups of all triangles, their boxes in units of `unitWorld`; the last one may be smaller. Cost: one
/// pass.
std::vector<TriangleGroup> groupTriangles(const SurfaceMesh& mesh, double unitWorld = 1);

/// A part of a mesh's groups, a few here and a few there: which part shows more does not depend on how the view looks
/// at the mesh.
struct GroupPart {
    static constexpr std::size_t kDealt = 8;  ///< Groups that follow each other; they share points.
    std::size_t part = 0, parts = 1;

    bool has(std::size_t deal) const { return deal % parts == part; }
};

/// Which groups may show in a part of the image. A rank that draws a few rows looks at their triangles alone.
class VisibleGroups {
public:
    /// Local. Tests boxes against the extent's sides: finds all groups of `part` that show, and a few that do not.
    /// Cost: 20 ns a group.
    void find(const std::vector<TriangleGroup>& groups, std::size_t triangles, const View& view, const Extent& extent,
              const GroupPart& part = {});

    std::size_t groups() const { return seen_.size(); }
    std::size_t blocks() const { return blocks_.size(); }  ///< Up to the last with a triangle's point.
    bool seesBlock(std::size_t block) const { return blocks_[block] != 0; }

    /// Calls body(begin, end) for ranges of triangles within groups [first, last) that may show, in ascending order.
    template <class Body>
    void forEachRange(std::size_t first, std::size_t last, const Body& body) const
    {
        for (std::size_t g = first; g < last; ++g) {
            if (!seen_[g]) continue;
            const std::size_t begin = g;
            while (g < last && seen_[g]) ++g;
            body(begin * kGroupTriangles, std::min(g * kGroupTriangles, triangles_));
        }
    }

private:
    std::vector<std::uint8_t> seen_, blocks_;
    std::size_t triangles_ = 0;
};

}  // namespace aeolic::cpu
