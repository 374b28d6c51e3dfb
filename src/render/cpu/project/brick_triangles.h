#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "data/scene.h"

namespace aeolic::cpu {

/// Which triangles reach into the box of a field's brick. Pixels of others are no pixels of the brick, though they may
/// hide some.
class BrickTriangles {
public:
    /// Local. Of the scene's field and surface as they are now. Cost: a pass over the triangles where either is
    /// another than at the last call, else nothing.
    void update(const Scene& scene);
    /// Local. The surface has changed.
    void forget() { of_.reset(); }

    /// [triangles]: 1 for those that do, 0 for others.
    const std::vector<std::uint32_t>& reaching() const { return reaching_; }

private:
    struct Place {
        glm::dvec3 originWorld, spacingWorld;
        std::optional<Brick> brick;
        bool operator==(const Place&) const = default;
    };
    std::optional<Place> of_;
    std::vector<std::uint32_t> reaching_;
};

}  // namespace aeolic::cpu
