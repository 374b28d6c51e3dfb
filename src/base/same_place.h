#pragma once

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

#include "base/fnv.h"

namespace aeolic {

/// A hash for points that are one where their coordinates are equal.
struct SamePlace {
    std::size_t operator()(const glm::dvec3& p) const
    {
        Fnv hash;
        for (int c = 0; c < 3; ++c) hash.mix(std::bit_cast<std::uint64_t>(p[c] + 0.0));  // -0 equals 0.
        return std::size_t(hash.value);
    }
};

}  // namespace aeolic
