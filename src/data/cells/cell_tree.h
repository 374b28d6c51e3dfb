#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/bounds.h"

namespace aeolic {

/// Finds boxes near points: a balanced tree of boxes. Immutable once built, so any number of threads may ask. It is the
/// same from any number of threads.
class CellTree {
public:
    /// In floats, which take half of the memory: rounded outwards, it holds all that the exact box holds.
    struct Box {
        glm::vec3 lo, hi;
        static Box around(const Bounds& exact);
    };

    /// Cost: O(n log n), in parallel below the first levels.
    explicit CellTree(std::vector<Box> boxes);

    Bounds bounds() const { return {glm::dvec3(nodes_[1].lo), glm::dvec3(nodes_[1].hi)}; }

    /// Calls visit(i) for every box that comes closer to `point` than the square root of what `limitSquared()` gives,
    /// or as close. It is asked again and again, so visits may lower it. Near boxes come first.
    template <class Limit, class Visit>
    void forEachNear(const glm::dvec3& point, const Limit& limitSquared, const Visit& visit) const
    {
        search(1, 0, point, limitSquared, visit);
    }

    /// The squared distance of a point from a box; 0 within.
    template <class AnyBox>
    static double distanceSquared(const AnyBox& box, const glm::dvec3& point)
    {
        const glm::dvec3 lo(box.lo), hi(box.hi), beyond = glm::max(glm::max(lo - point, point - hi), glm::dvec3(0));
        return glm::dot(beyond, beyond);
    }

private:
    static constexpr std::size_t kLeaf = 4;  // Boxes.

    void sortBoxes();

    /// Where node `node` of `level` begins in the list of boxes.
    std::size_t begin(std::size_t node, int level) const
    {
        return std::size_t((node - (std::size_t{1} << level)) * std::uint64_t(order_.size()) >> level);
    }

    template <class Limit, class Visit>
    void search(std::size_t node, int level, const glm::dvec3& point, const Limit& limitSquared,
                const Visit& visit) const
    {
        if (level == levels_) {
            for (std::size_t k = begin(node, level); k < begin(node + 1, level); ++k)
                if (distanceSquared(boxes_[order_[k]], point) <= limitSquared()) visit(order_[k]);
            return;
        }
        std::size_t near = 2 * node, far = near + 1;
        double nearSquared = distanceSquared(nodes_[near], point), farSquared = distanceSquared(nodes_[far], point);
        if (farSquared < nearSquared) {
            std::swap(near, far);
            std::swap(nearSquared, farSquared);
        }
        if (nearSquared <= limitSquared()) search(near, level + 1, point, limitSquared, visit);
        if (farSquared <= limitSquared()) search(far, level + 1, point, limitSquared, visit);
    }

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;  // The boxes, those of a node side by side.
    std::vector<Box> nodes_;            // The children of node i are 2 i and 2 i + 1; the root is 1.
    int levels_ = 0;
};

}  // namespace aeolic
