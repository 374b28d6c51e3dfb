#include "data/load/series/interpolate.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/half.h"
#include "base/large_memory.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "data/mesh/triangle_order.h"

namespace aeolic {

namespace {

constexpr std::size_t grain = std::size_t{1} << 14;

float between(float a, float b, double weight)
{
    return float(double(a) + weight * (double(b) - double(a)));
}

glm::vec3 between(const glm::vec3& a, const glm::vec3& b, double weight)
{
    return {between(a.x, b.x, weight), between(a.y, b.y, weight), between(a.z, b.z, weight)};
}

template <class Value>
std::vector<Value> between(const std::vector<Value>& a, const std::vector<Value>& b, double weight)
{
    std::vector<Value> out(a.size());
    parallelRanges(a.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = between(a[i], b[i], weight);
    });
    return out;
}

/// The number that each point of `first` has in `second`; empty where one has points that the other has not.
std::vector<std::uint32_t> matchingPoints(const LoadedSurface& first, const LoadedSurface& second)
{
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    if (first.pointIds.size() != second.pointIds.size() || first.pointIds.empty()) return {};
    std::vector<std::uint32_t> ofId(std::size_t(*std::ranges::max_element(second.pointIds)) + 1, none);
    for (std::size_t i = 0; i < second.pointIds.size(); ++i) ofId[second.pointIds[i]] = std::uint32_t(i);
    std::vector<std::uint32_t> match;
    match.reserve(first.pointIds.size());
    for (const std::uint32_t id : first.pointIds) {
        if (id >= ofId.size() || ofId[id] == none) return {};
        match.push_back(ofId[id]);
    }
    return match;
}

bool sameArrays(const SurfaceMesh& a, const SurfaceMesh& b)
{
    return a.positions.size() == b.positions.size() && a.triangles.size() == b.triangles.size() &&
           a.pointVectors.size() == b.pointVectors.size() && a.cellVectors.size() == b.cellVectors.size() &&
           a.pointScalars.size() == b.pointScalars.size() && a.cellScalars.size() == b.cellScalars.size();
}

}  // namespace

bool sameGrid(const GridField& a, const GridField& b)
{
    return a.dims == b.dims && a.brick == b.brick && a.originWorld == b.originWorld &&
           a.spacingWorld == b.spacingWorld && a.components == b.components && a.precision == b.precision &&
           a.tiled == b.tiled;
}

std::shared_ptr<GridField> interpolated(const GridField& first, const GridField& second, double weight,
                                        std::shared_ptr<GridField> reuse)
{
    const std::size_t count = first.sampleCount() * std::size_t(first.components);
    std::shared_ptr<const void> memory;
    if (reuse && sameGrid(*reuse, first)) memory = reuse->samples;
    reuse.reset();  // Memory that does not fit is freed before more is asked for.
    if (!memory) requireMemory(first.name, "a moment between two time steps", first.bytes());
    auto field = std::make_shared<GridField>(first);
    field->maxMagnitude = std::max(first.maxMagnitude, second.maxMagnitude);  // A bound: nothing between is longer.
    const auto fill = [&](auto* out, const auto* a, const auto* b, const auto& blend) {
        parallelRanges(count, grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) out[i] = blend(a[i], b[i]);
        });
    };
    if (first.precision == FieldPrecision::float32) {
        if (!memory) memory = std::shared_ptr<float>(makeLargeArray<float>(count).release(), FreeLarge());
        fill(static_cast<float*>(const_cast<void*>(memory.get())), first.floats(), second.floats(),
             [&](float a, float b) { return between(a, b, weight); });
    } else {
        // A gather of the last halves may read past them.
        if (!memory)
            memory = std::shared_ptr<std::uint16_t>(makeLargeArray<std::uint16_t>(count + 2).release(), FreeLarge());
        fill(static_cast<std::uint16_t*>(const_cast<void*>(memory.get())), first.halves(), second.halves(),
             [&](std::uint16_t a, std::uint16_t b) {
                 return halfFromFloat(between(floatFromHalf(a), floatFromHalf(b), weight));
             });
    }
    field->samples = std::move(memory);
    return field;
}

bool interpolable(const LoadedSurface& first, const LoadedSurface& second)
{
    return first.topology != 0 && first.topology == second.topology && sameArrays(first.mesh, second.mesh) &&
           (first.pointIds == second.pointIds || !matchingPoints(first, second).empty());
}

std::optional<LoadedSurface> interpolated(const LoadedSurface& first, const LoadedSurface& second, double weight)
{
    if (first.topology == 0 || first.topology != second.topology || !sameArrays(first.mesh, second.mesh))
        return std::nullopt;
    SurfaceMesh other = second.mesh;
    if (first.pointIds !=
        second.pointIds) {  // Polygons were cut into other triangles, and points met in another order.
        const std::vector<std::uint32_t> order = matchingPoints(first, second);
        if (order.empty()) return std::nullopt;
        permute(other.positions, order);
        permute(other.normals, order);
        permute(other.pointVectors, order);
        permute(other.pointScalars, order);
    }
    setOrigin(other, first.mesh.originWorld);
    LoadedSurface surface = first;
    SurfaceMesh& mesh = surface.mesh;
    mesh.positions = between(first.mesh.positions, other.positions, weight);
    mesh.pointVectors = between(first.mesh.pointVectors, other.pointVectors, weight);
    mesh.cellVectors = between(first.mesh.cellVectors, other.cellVectors, weight);
    mesh.pointScalars = between(first.mesh.pointScalars, other.pointScalars, weight);
    mesh.cellScalars = between(first.mesh.cellScalars, other.cellScalars, weight);
    if (first.mesh.normals.empty() || other.normals.empty()) {
        mesh.normals.clear();
        return surface;
    }
    mesh.normals = between(first.mesh.normals, other.normals, weight);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const float length = glm::length(mesh.normals[i]);
        mesh.normals[i] = length > 1e-6f ? mesh.normals[i] / length : first.mesh.normals[i];
    }
    return surface;
}

void setOrigin(SurfaceMesh& mesh, const glm::dvec3& originWorld)
{
    if (mesh.originWorld == originWorld) return;
    const glm::dvec3 shift = mesh.originWorld - originWorld;
    parallelRanges(mesh.positions.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) mesh.positions[i] = glm::vec3(glm::dvec3(mesh.positions[i]) + shift);
    });
    mesh.originWorld = originWorld;
}

}  // namespace aeolic
