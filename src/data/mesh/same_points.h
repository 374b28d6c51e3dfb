#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace aeolic {

/// [points] the first of those in the same place, which may be the point itself. Cost: a sort.
std::vector<std::uint32_t> firstsOfPlaces(const std::vector<glm::vec3>& positions);

}  // namespace aeolic
