#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace aeolic {

/// Axis-aligned bounds in world coordinates.
struct Bounds {
    glm::dvec3 lo{std::numeric_limits<double>::infinity()};
    glm::dvec3 hi{-std::numeric_limits<double>::infinity()};

    bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    void add(const glm::dvec3& p)
    {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void add(const Bounds& other)
    {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
    glm::dvec3 center() const { return 0.5 * (lo + hi); }
    double diagonal() const { return empty() ? 0.0 : glm::length(hi - lo); }
};

}  // namespace aeolic
