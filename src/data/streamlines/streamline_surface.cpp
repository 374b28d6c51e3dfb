#include "data/streamlines/streamline_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "base/bounds.h"
#include "base/mixed_bits.h"
#include "base/parallel.h"
#include "data/mesh/nearest_in_triangle.h"

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
      along_({mesh_, fans_, flow_}),
      across_({mesh_, fans_, flow_}, Along::acrossFlow),
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

SurfacePlace StreamlineSurface::nearest(const glm::dvec3& pointWorld) const
{
    constexpr std::size_t grain = 4096;
    const glm::dvec3 point = pointWorld - mesh_.originWorld;
    const auto weightsIn = [&](std::size_t t) {
        const auto& [a, b, c] = mesh_.triangles[t];
        return nearestInTriangle(point, glm::dvec3(mesh_.positions[a]), glm::dvec3(mesh_.positions[b]),
                                 glm::dvec3(mesh_.positions[c]));
    };
    std::pair<double, std::size_t> nearest{std::numeric_limits<double>::infinity(), 0};
    std::mutex guard;
    parallelRanges(mesh_.triangles.size(), grain, [&](std::size_t begin, std::size_t end) {
        std::pair<double, std::size_t> own{std::numeric_limits<double>::infinity(), begin};
        for (std::size_t t = begin; t < end; ++t) {
            const SurfacePlace place{std::uint32_t(t), weightsIn(t)};
            own = std::min(own, {glm::length(positionWorld(mesh_, place) - pointWorld), t});
        }
        const std::scoped_lock lock(guard);
        nearest = std::min(nearest, own);
    });
    return {std::uint32_t(nearest.second), weightsIn(nearest.second)};
}

std::array<std::vector<glm::vec3>, 2> StreamlineSurface::through(const SurfacePlace& place) const
{
    std::array<std::vector<glm::vec3>, 2> parts;
    if (!hasFlow(place.triangle)) return parts;
    for (const int direction : {-1, 1}) {
        std::vector<glm::vec3>& part = parts[direction < 0 ? 0 : 1];
        for (const SurfacePlace& each : along_.trace(place, direction, 4 * size_ * unitWorld_).places)
            part.push_back(at(each));
    }
    std::ranges::reverse(parts[0]);
    return parts;
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
