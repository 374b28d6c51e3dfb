#pragma once

#include <array>
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

    /// `place`: a point or a box. Calls visit(i) for every box that comes closer to it than the square root of what
    /// `limitSquared()` gives, or as close. It is asked again and again, so visits may lower it. Near boxes come first.
    template <class Place, class Limit, class Visit>
    void forEachNear(const Place& place, const Limit& limitSquared, const Visit& visit) const
    {
        struct Open {
            std::size_t node;
            double squared;
        };
        std::array<Open, kMostLevels + 2> open;  // One sibling a level waits.
        std::size_t waiting = 0;
        open[waiting++] = {1, 0};
        while (waiting > 0) {
            auto [node, squared] = open[--waiting];
            if (!(squared <= limitSquared())) continue;
            while (node < leaves_) {
                std::size_t far = 2 * node + 1;
                node = 2 * node;
                double farSquared = distanceSquared(nodes_[far], place);
                squared = distanceSquared(nodes_[node], place);
                if (farSquared < squared) {
                    std::swap(node, far);
                    std::swap(squared, farSquared);
                }
                const double limit = limitSquared();
                if (farSquared <= limit) open[waiting++] = {far, farSquared};
                if (!(squared <= limit)) break;
            }
            if (node < leaves_) continue;
            for (std::size_t k = begin(node, levels_); k < begin(node + 1, levels_); ++k)
                if (distanceSquared(boxes_[k], place) <= limitSquared()) visit(order_[k]);
        }
    }

    /// The squared distance of a point from a box; 0 within.
    template <class AnyBox>
    [[gnu::always_inline]] static double distanceSquared(const AnyBox& box, const glm::dvec3& point)
    {
        const glm::dvec3 lo(box.lo), hi(box.hi), beyond = glm::max(glm::max(lo - point, point - hi), glm::dvec3(0));
        return glm::dot(beyond, beyond);
    }

    /// The squared distance of two boxes; 0 where they touch.
    [[gnu::always_inline]] static double distanceSquared(const Box& box, const Box& other)
    {
        const glm::dvec3 beyond =
            glm::max(glm::max(glm::dvec3(box.lo) - glm::dvec3(other.hi), glm::dvec3(other.lo) - glm::dvec3(box.hi)),
                     glm::dvec3(0));
        return glm::dot(beyond, beyond);
    }

private:
    static constexpr std::size_t kLeaf = 4;         // Boxes.
    static constexpr std::size_t kMostLevels = 32;  // Boxes are numbered by 32 bits.

    void sortBoxes();

    /// Where node `node` of `level` begins in the list of boxes.
    std::size_t begin(std::size_t node, int level) const
    {
        return std::size_t((node - (std::size_t{1} << level)) * std::uint64_t(order_.size()) >> level);
    }

    std::vector<Box> boxes_;            // Those of a node side by side.
    std::vector<std::uint32_t> order_;  // [boxes_] Their numbers.
    std::vector<Box> nodes_;            // The children of node i are 2 i and 2 i + 1; the root is 1.
    int levels_ = 0;
    std::size_t leaves_ = 1;  // How many, and the number of the first.
};

}  // namespace aeolic
