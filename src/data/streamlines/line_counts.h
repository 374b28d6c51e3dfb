#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/streamlines/near_samples.h"

namespace aeolic {

/// How many samples of streamlines are near a place, for many samples that do not change. They lie in memory by the
/// cells of a grid, so that those of one cell are beside each other. Those count that face the same way.
class LineCounts {
public:
    /// `reach`: within which samples are counted. Cost: a sort.
    LineCounts(const std::vector<LineSample>& samples, float reach);

    /// How many are within the reach. Cost: that of those within twice the reach.
    std::size_t near(const LineSample& place) const;

    /// No fewer than that, at once.
    std::size_t atMost(const LineSample& place) const;

private:
    struct Cell {
        std::uint64_t key = 0;
        std::uint32_t begin = 0, end = 0;  // Empty: the place in the table is free.
    };
    struct Kept {
        glm::vec3 at, normal;
    };
    glm::ivec3 cellOf(const glm::vec3& at) const;
    const Cell* find(const glm::ivec3& cell) const;
    template <class Visit>
    void forEachCell(const glm::vec3& at, const Visit& visit) const;

    float reach_;
    std::vector<Kept> samples_;  // By cell.
    std::vector<Cell> table_;    // A power of two, by hash.
};

}  // namespace aeolic
