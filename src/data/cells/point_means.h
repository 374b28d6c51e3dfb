#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/uninitialized.h"

namespace aeolic {

/// Values of cells as means at points, where a mesh lies in pieces: at a point on the outside of a piece the cells of
/// its neighbours meet, too. What one piece says of those points.
struct PointMeans {
    std::vector<glm::dvec3> placesWorld;
    std::vector<std::uint32_t> points;  ///< [places] Which of the piece's own points it is.
    std::vector<std::uint32_t> cells;   ///< [places] How many of the piece's cells meet there and count.
    /// [places] The dimension of those cells. Where another piece has cells of a higher one, they do not count.
    std::vector<std::uint8_t> dimensions;
    std::uint32_t width = 0;    ///< Values a place: those of all arrays, one after the other.
    std::vector<float> values;  ///< [places * width] Their means.
};

/// Means as a message to other ranks.
Bytes messageOf(const PointMeans& means);

/// Throws std::runtime_error for a message that is malformed.
PointMeans meansOf(std::span<const std::byte> message);

/// `pieces`: those of the whole mesh. Where a place belongs to several of them its values become the means of all cells
/// of the highest dimension that meet there, the same bits in each. A place that a piece has twice, as on either side
/// of a thin wall, stays as it is. Throws std::runtime_error where pieces have different arrays. Cost: O(places).
void uniteMeans(std::span<PointMeans> pieces);

}  // namespace aeolic
