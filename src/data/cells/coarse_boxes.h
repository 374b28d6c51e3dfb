#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "base/bounds.h"

namespace aeolic {

/// Boxes of one size that cover a part of space. What is outside of it counts to the box at its border.
struct CoarseBoxes {
    glm::dvec3 lo{0}, boxesPerWorld{0};
    glm::ivec3 count{0};

    CoarseBoxes() = default;

    /// For so many places, some dozens in each box; none where they would not help.
    CoarseBoxes(const Bounds& boundsWorld, std::size_t places);

    std::size_t size() const { return std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z); }
    std::size_t indexOf(const glm::dvec3& pointWorld) const { return indexAt(boxOf(pointWorld)); }
    glm::dvec3 middleOf(std::size_t index) const;

    /// How many boxes have a part of `boundsWorld`, or a place outside that counts to them.
    double countIn(const Bounds& boundsWorld) const;

    /// Calls visit(index) for each of these.
    template <class Visit>
    void forEachIn(const Bounds& boundsWorld, const Visit& visit) const
    {
        const glm::ivec3 first = boxOf(boundsWorld.lo), last = boxOf(boundsWorld.hi);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x) visit(indexAt({x, y, z}));
    }

private:
    glm::ivec3 boxOf(const glm::dvec3& pointWorld) const
    {
        return glm::ivec3(glm::clamp((pointWorld - lo) * boxesPerWorld, glm::dvec3(0), glm::dvec3(count - 1)));
    }
    std::size_t indexAt(const glm::ivec3& box) const
    {
        return std::size_t((box.z * count.y + box.y) * count.x + box.x);
    }
};

}  // namespace aeolic
