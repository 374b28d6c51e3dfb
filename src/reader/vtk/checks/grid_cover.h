#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace aeolic {

/// First and last point in x, y and z.
using GridExtent = std::array<std::int64_t, 6>;

/// A cell of `whole` that none of the pieces has, if there is one. Pieces lie within the whole, and may overlap.
std::optional<std::array<std::int64_t, 3>> firstUncovered(const std::vector<GridExtent>& pieces,
                                                          const GridExtent& whole);

}  // namespace aeolic
