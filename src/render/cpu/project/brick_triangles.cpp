#include "render/cpu/project/brick_triangles.h"

#include <limits>

#include "base/parallel.h"
#include "render/brick_image.h"

namespace aeolic::cpu {
namespace {

// The pixels' positions are interpolated in floats, and the field's rim belongs to its outermost cells.
constexpr double kMarginCells = 0.25;

}  // namespace

void BrickTriangles::update(const Scene& scene)
{
    const GridField& field = *scene.field;
    const Place place{field.originWorld, field.spacingWorld, field.brick};
    if (of_ == place) return;
    of_ = place;
    const SurfaceMesh& mesh = scene.surface;
    Bounds box{glm::dvec3(-std::numeric_limits<double>::infinity()),
               glm::dvec3(std::numeric_limits<double>::infinity())};
    if (field.brick) box = brickBounds(field, kMarginCells);
    const glm::vec3 boxLo(box.lo - mesh.originWorld), boxHi(box.hi - mesh.originWorld);
    reaching_.resize(mesh.triangles.size());
    parallelRanges(reaching_.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& t = mesh.triangles[i];
            const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
            const glm::vec3 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
            reaching_[i] = glm::all(glm::lessThanEqual(lo, boxHi)) && glm::all(glm::greaterThanEqual(hi, boxLo));
        }
    });
}

}  // namespace aeolic::cpu
