#include "data/streamlines/streamline_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/bounds.h"

namespace aeolic {
namespace {

constexpr double kPi = std::numbers::pi;

/// At sharp edges each triangle has what the vectors are along it.
TangentField withSharpEdges(TangentField field, const std::vector<glm::vec3>& vectors, std::vector<std::uint8_t> sharp)
{
    field.own = &vectors;
    field.sharp = std::move(sharp);
    return field;
}

/// The field turned by a quarter: its lines run across the flow, to the left.
TangentField turned(TangentField field)
{
    for (double& rad : field.rad) rad += rad < 1.5 * kPi ? 0.5 * kPi : -1.5 * kPi;
    field.turned = true;
    return field;
}

/// A number in [0, 1) that follows from two others by chance.
double chance(std::uint64_t number, std::uint64_t which)
{
    std::uint64_t x = number * 2 + which + 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;  // The mixing of SplitMix64.
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return double((x ^ (x >> 31)) >> 11) * 0x1p-53;
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
    : vectors_(std::move(vectors)),
      mesh_(bare(std::move(mesh))),
      fans_(surfaceFans(mesh_)),
      flow_(withSharpEdges(tangentField(mesh_, fans_, vectors_), vectors_, sharpFans(mesh_, fans_))),
      acrossFlow_(turned(flow_)),
      along_(mesh_, fans_, flow_),
      across_(mesh_, fans_, acrossFlow_),
      areas_(mesh_.triangles.size())
{
    const auto at = [&](std::size_t t, std::size_t i) { return glm::dvec3(mesh_.positions[mesh_.triangles[t][i]]); };
    Bounds box;
    for (std::uint32_t t = 0; t < areas_.size(); ++t)
        if (hasFlow(t))
            for (std::size_t i = 0; i < 3; ++i) box.add(at(t, i));
    const double sizeWorld = box.empty() ? 0 : glm::length(box.hi - box.lo);
    if (sizeWorld > 0) unitWorld_ = std::exp2(std::floor(std::log2(sizeWorld)));
    size_ = sizeWorld / unitWorld_;
    double sum = 0;
    for (std::uint32_t t = 0; t < areas_.size(); ++t) {
        const glm::dvec3 first = (at(t, 1) - at(t, 0)) / unitWorld_, second = (at(t, 2) - at(t, 0)) / unitWorld_;
        if (hasFlow(t)) sum += 0.5 * glm::length(glm::cross(first, second));
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
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh_.positions[mesh_.triangles[triangle][i]]); };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
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
