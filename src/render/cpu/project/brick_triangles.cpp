#include "render/cpu/project/brick_triangles.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"

namespace aeolic::cpu {
namespace {

// The pixels' positions are interpolated in floats, and the field's rim belongs to its outermost cells.
constexpr double kMarginCells = 0.25;

struct Box {
    glm::vec3 lo, hi;
};

/// In the surface's local coordinates.
Box localBox(const GridField& field, const glm::dvec3& surfaceOriginWorld)
{
    Box box{glm::vec3(-std::numeric_limits<float>::infinity()), glm::vec3(std::numeric_limits<float>::infinity())};
    for (int c = 0; field.brick && c < 3; ++c) {
        const auto a = std::size_t(c);
        const auto local = [&](double cell) {
            return float(field.originWorld[c] + cell * field.spacingWorld[c] - surfaceOriginWorld[c]);
        };
        box.lo[c] = local(double(field.brick->cellLo[a]) - kMarginCells);
        box.hi[c] = local(double(field.brick->cellHi[a]) + kMarginCells);
    }
    return box;
}

}  // namespace

void BrickTriangles::update(const Scene& scene)
{
    const GridField& field = *scene.field;
    const Place place{field.originWorld, field.spacingWorld, field.brick};
    if (of_ == place) return;
    of_ = place;
    const SurfaceMesh& mesh = scene.surface;
    const Box box = localBox(field, mesh.originWorld);
    reaching_.resize(mesh.triangles.size());
    parallelRanges(reaching_.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& t = mesh.triangles[i];
            const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
            const glm::vec3 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
            reaching_[i] = glm::all(glm::lessThanEqual(lo, box.hi)) && glm::all(glm::greaterThanEqual(hi, box.lo));
        }
    });
}

}  // namespace aeolic::cpu
