#include "data/mesh/surface_mesh.h"

#include <cmath>

namespace aeolic {
namespace {

template <class Value>
void appendAgain(std::vector<Value>& values, std::uint32_t point)
{
    if (values.empty()) return;
    const Value value = values[point];  // A reference into the vector would not survive its growth.
    values.push_back(value);
}

}  // namespace

std::uint32_t SurfaceMesh::copyPoint(std::uint32_t point)
{
    appendAgain(positions, point);
    appendAgain(normals, point);
    appendAgain(pointVectors, point);
    appendAgain(pointScalars, point);
    appendAgain(surfaceOf, point);
    return std::uint32_t(positions.size() - 1);
}

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
