#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

#include "base/same_place.h"

namespace aeolic {

/// Points of several meshes. `merges`: those at the same place are one.
class FoamPoints {
public:
    explicit FoamPoints(bool merges) : merges_(merges) {}

    /// Its number among all.
    std::int64_t add(const glm::dvec3& point)
    {
        const auto next = std::int64_t(all.size());
        if (merges_) {
            const auto [at, isNew] = places_.try_emplace(point, next);
            if (!isNew) return at->second;
        }
        all.push_back(point);
        return next;
    }

    bool merges() const { return merges_; }
    void forgetPlaces() { places_.clear(); }

    std::vector<glm::dvec3> all;

private:
    const bool merges_;
    std::unordered_map<glm::dvec3, std::int64_t, SamePlace> places_;
};

}  // namespace aeolic
