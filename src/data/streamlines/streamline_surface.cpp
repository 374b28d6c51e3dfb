#include "data/streamlines/streamline_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/bounds.h"
#include "base/mixed_bits.h"

namespace aeolic {
namespace {

/// The flow, which at sharp edges is what the vectors are along each triangle.
TangentField flowOf(const SurfaceMesh& mesh, const SurfaceFans& fans, std::vector<glm::vec3> vectors)
{
    TangentField field = tangentField(mesh, fans, vectors);
    field.sharp = sharpFans(mesh, fans);
    field.own = std::move(vectors);
    return field;
}

/// A number in [0, 1) that follows from two others by chance.
double chance(std::uint64_t number, std::uint64_t which)
{
    return double(mixedBits(number * 2 + which + 1) >> 11) * 0x1p-53;
}

/// What streamlines need of a mesh.
SurfaceMesh bare(SurfaceMesh mesh)
{
    SurfaceMesh kept;
    kept.originWorld = mesh.originWorld;
    kept.positions = std::move(mesh.positions);
    kept.triangles = std::move(mesh.triangles);
    return kept;
}

}  // namespace

StreamlineSurface::StreamlineSurface(SurfaceMesh mesh, std::vector<glm::vec3> vectors)
    : mesh_(bare(std::move(mesh))),
      fans_(surfaceFans(mesh_)),
      flow_(flowOf(mesh_, fans_, std::move(vectors))),
      along_(mesh_, fans_, flow_),
      across_(mesh_, fans_, flow_, Along::acrossFlow),
      areas_(mesh_.triangles.size())
{
    Bounds box;
    for (std::uint32_t t = 0; t < areas_.size(); ++t)
        if (hasFlow(t))
            for (const std::uint32_t point : mesh_.triangles[t]) box.add(glm::dvec3(mesh_.positions[point]));
    const double sizeWorld = box.empty() ? 0 : glm::length(box.hi - box.lo);
    if (sizeWorld > 0) unitWorld_ = std::exp2(std::floor(std::log2(sizeWorld)));
    size_ = sizeWorld / unitWorld_;
    double sum = 0;
    for (std::uint32_t t = 0; t < areas_.size(); ++t) {
        if (hasFlow(t)) sum += 0.5 * glm::length(areaVector(mesh_, t) / (unitWorld_ * unitWorld_));
        areas_[t] = sum;
    }
}

bool StreamlineSurface::hasFlow(std::uint32_t triangle) const
{
    if (flow_.masked[triangle]) return false;
    for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
        if (flow_.length[fans_.fanOf[corner]] > 0) return true;
    return false;
}

glm::vec3 StreamlineSurface::normal(std::uint32_t triangle) const
{
    return glm::normalize(areaVector(mesh_, triangle));
}

SurfacePlace StreamlineSurface::spread(std::size_t which, std::size_t count) const
{
    const double passed = (double(which) + chance(which, 0)) / double(count) * area();
    const auto found = std::upper_bound(areas_.begin(), areas_.end(), passed);
    const auto triangle = std::uint32_t(std::min(found - areas_.begin(), std::ptrdiff_t(areas_.size()) - 1));
    const double u = std::sqrt(chance(which, 1)), v = chance(~which, 0);
    return {triangle, {1 - u, u * (1 - v), u * v}};
}

}  // namespace aeolic
