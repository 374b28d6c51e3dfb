#include "data/mesh/surface_mesh.h"

#include <cmath>

namespace aeolic {

Bounds SurfaceMesh::bounds() const
{
    glm::vec3 lo(std::numeric_limits<float>::infinity()), hi(-std::numeric_limits<float>::infinity());
    for (const glm::vec3& p : positions) {
        // A file may hold non-finite points; no triangle uses them, and one must not blow up the view of all others.
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    return {originWorld + glm::dvec3(lo), originWorld + glm::dvec3(hi)};
}

}  // namespace aeolic
