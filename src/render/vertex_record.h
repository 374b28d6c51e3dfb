#pragma once

#include <vector>

#include "data/scene.h"
#include "render/surface_mark.h"
#include "render/units.h"

namespace aeolic {

/// One surface point as the projection stage reads it: three 128-bit loads where ten gathers would take four times as
/// long. The third is read only where the surface carries its own vectors.
struct alignas(16) VertexRecord {
    float position[3], normalX;
    float normalY, normalZ, scalar, mark;  // surface_mark.h; 0 where there is only one surface.
    float vector[3], unused;
};
static_assert(sizeof(VertexRecord) == 48);

/// Makes the records of a scene's points, with positions in kernels' unit (units.h).
class VertexRecords {
public:
    explicit VertexRecords(const Scene& scene) : mesh_(scene.surface), perUnit_(float(1 / lengthUnit(scene)))
    {
        for (const SceneSurface& surface : scene.surfaces) marks_.push_back(float(surface_mark::of(surface)));
    }

    VertexRecord operator()(std::size_t i) const
    {
        const glm::vec3 p = perUnit_ * mesh_.positions[i];
        const glm::vec3& n = mesh_.normals[i];
        const glm::vec3 u = mesh_.pointVectors.empty() ? glm::vec3(0) : mesh_.pointVectors[i];
        const float scalar = mesh_.pointScalars.empty() ? 0.0f : mesh_.pointScalars[i],
                    mark = mesh_.surfaceOf.empty() ? 0.0f : marks_[mesh_.surfaceOf[i]];
        return {{p.x, p.y, p.z}, n.x, n.y, n.z, scalar, mark, {u.x, u.y, u.z}, 0};
    }

private:
    const SurfaceMesh& mesh_;
    float perUnit_;
    std::vector<float> marks_;  // [surfaces]
};

}  // namespace aeolic
