#include "data/surface_range.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/half.h"
#include "base/parallel.h"
#include "data/field_tiles.h"

namespace aeolic {

namespace {

constexpr std::size_t rangeGrain = 4096;
constexpr int mostSubdivisions = 256;  // Bounds the cost of a huge triangle; 33,000 samples are enough for a range.

struct Range {
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        if (!std::isfinite(value)) return;
        lo = std::min(lo, value);
        hi = std::max(hi, value);
    }
    std::optional<std::array<double, 2>> get() const
    {
        return lo <= hi ? std::optional(std::array{lo, hi}) : std::nullopt;
    }
};

/// Runs add(range, i) for all i on all threads.
template <class Add>
Range parallelRange(std::size_t count, const Add& add)
{
    Range total;
    std::mutex totalMutex;
    parallelRanges(count, rangeGrain, [&](std::size_t begin, std::size_t end) {
        Range part;
        for (std::size_t i = begin; i < end; ++i) add(part, i);
        const std::lock_guard lock(totalMutex);
        total.add(part.lo);
        total.add(part.hi);
    });
    return total;
}

double component(const GridField& field, std::size_t sample, int c)
{
    const std::size_t i = sample * std::size_t(field.components) + std::size_t(c);
    return field.precision == FieldPrecision::float32 ? field.floats()[i] : floatFromHalf(field.halves()[i]);
}

}  // namespace

FieldVector vectorAt(const GridField& field, const glm::dvec3& pointWorld)
{
    const glm::dvec3 grid = (pointWorld - field.originWorld) / field.spacingWorld;
    std::size_t base[3];
    double weight[3];
    for (int c = 0; c < 3; ++c) {
        const auto top = double(field.dims[std::size_t(c)] - 1);
        if (!(grid[c] >= -1e-4 && grid[c] <= top + 1e-4)) return {};
        const double cell = std::clamp(std::floor(grid[c]), 0.0, top - 1);
        base[c] = std::size_t(cell);
        weight[c] = std::clamp(grid[c] - cell, 0.0, 1.0);
    }
    if (field.brick) {  // Every cell belongs to one rank: the range of all bricks is the range of the whole.
        if (!field.brick->owns({std::int64_t(base[0]), std::int64_t(base[1]), std::int64_t(base[2])}))
            return {true, true, glm::dvec3(0)};
        for (std::size_t c = 0; c < 3; ++c) base[c] -= std::size_t(field.brick->cellLo[c]);
    }
    const GridIndex held = field.heldDims();
    const auto index = [&](std::size_t x, std::size_t y, std::size_t z) {
        return field.tiled ? std::size_t(FieldTiles::index(held, std::int64_t(x), std::int64_t(y), std::int64_t(z)))
                           : (z * std::size_t(held[1]) + y) * std::size_t(held[0]) + x;
    };
    FieldVector found{true, false, glm::dvec3(0)};
    for (int k = 0; k < field.components; ++k) {
        double value = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const std::size_t x = corner & 1u, y = corner >> 1 & 1u, z = corner >> 2;
            const double w =
                (x ? weight[0] : 1 - weight[0]) * (y ? weight[1] : 1 - weight[1]) * (z ? weight[2] : 1 - weight[2]);
            value += w * component(field, index(base[0] + x, base[1] + y, base[2] + z), k);
        }
        found.vector[k] = value;
    }
    return found;
}

std::vector<FieldVector> vectorsAt(const GridField& field, const std::vector<glm::dvec3>& pointsWorld)
{
    std::vector<FieldVector> found(pointsWorld.size());
    parallelRanges(found.size(), rangeGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            found[i] = vectorAt(field, pointsWorld[i]);
            found[i].vector += 0.0;
        }
    });
    return found;
}

std::optional<std::array<double, 2>> finiteRange(const std::vector<float>& values)
{
    return parallelRange(values.size(), [&](Range& range, std::size_t i) { range.add(values[i]); }).get();
}

double valueOf(ArrayPart part, const glm::dvec3& vector, const glm::dvec3& normal)
{
    if (!needsNormal(part)) return glm::length(vector);
    const double across = glm::dot(vector, normal);
    return part == ArrayPart::normal ? across : glm::length(vector - across * normal);
}

glm::dvec3 normalAt(const SurfaceMesh& mesh, std::size_t triangle, double u, double v)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    const glm::dvec3 sum =
        (1 - u - v) * glm::dvec3(mesh.normals[a]) + u * glm::dvec3(mesh.normals[b]) + v * glm::dvec3(mesh.normals[c]);
    const double length = glm::length(sum);
    return length > 1e-4 ? sum / length : glm::dvec3(mesh.normals[a]);
}

std::optional<std::array<double, 2>> rangeOfVectors(const SurfaceMesh& mesh, ArrayPart part)
{
    const auto value = [&](const glm::vec3& vector, std::size_t point) {
        return valueOf(part, glm::dvec3(vector), glm::dvec3(mesh.normals[point]));
    };
    if (mesh.cellVectors.empty())
        return parallelRange(mesh.pointVectors.size(),
                             [&](Range& range, std::size_t i) { range.add(value(mesh.pointVectors[i], i)); })
            .get();
    return parallelRange(mesh.triangles.size(),
                         [&](Range& range, std::size_t i) {
                             for (const std::uint32_t corner : mesh.triangles[i])
                                 range.add(value(mesh.cellVectors[i], corner));
                         })
        .get();
}

std::optional<std::array<double, 2>> rangeOnSurface(const SurfaceMesh& mesh, const GridField& field, ArrayPart part)
{
    const double cell = std::min({field.spacingWorld.x, field.spacingWorld.y, field.spacingWorld.z});
    const auto take = [&](Range& range, const glm::dvec3& place, const auto& normal) {
        const FieldVector found = vectorAt(field, mesh.originWorld + place);
        if (!found.inside || found.elsewhere) return;  // Another rank has it, or nobody.
        range.add(field.components == 1 ? found.vector.x
                                        : valueOf(part, found.vector, needsNormal(part) ? normal() : glm::dvec3(0)));
    };
    // Each point once: a mesh has six times as many corners.
    Range all = parallelRange(mesh.positions.size(), [&](Range& range, std::size_t i) {
        take(range, glm::dvec3(mesh.positions[i]), [&] { return glm::dvec3(mesh.normals[i]); });
    });
    const Range within = parallelRange(mesh.triangles.size(), [&](Range& range, std::size_t i) {
        const auto& [ia, ib, ic] = mesh.triangles[i];
        const glm::dvec3 a = mesh.positions[ia], ab = glm::dvec3(mesh.positions[ib]) - a,
                         ac = glm::dvec3(mesh.positions[ic]) - a;
        const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
        const int n = int(std::clamp(std::ceil(longest / cell), 1.0, double(mostSubdivisions)));
        for (int u = 0; n > 1 && u <= n; ++u)
            for (int v = 0; u + v <= n; ++v) {
                const double s = double(u) / n, t = double(v) / n;
                take(range, a + s * ab + t * ac, [&] { return normalAt(mesh, i, s, t); });
            }
    });
    all.add(within.lo);
    all.add(within.hi);
    return all.get();
}

bool meets(const SurfaceMesh& mesh, const Bounds& boxWorld)
{
    const glm::dvec3 lo = boxWorld.lo - mesh.originWorld, hi = boxWorld.hi - mesh.originWorld;
    std::atomic<bool> found{false};
    parallelRanges(mesh.triangles.size(), rangeGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !found; ++i) {
            Bounds triangle;
            for (const std::uint32_t corner : mesh.triangles[i]) triangle.add(mesh.positions[corner]);
            if (glm::all(glm::lessThanEqual(triangle.lo, hi)) && glm::all(glm::greaterThanEqual(triangle.hi, lo)))
                found = true;
        }
    });
    return found;
}

Bounds boundsOf(const GridField& field)
{
    Bounds bounds;
    bounds.add(field.originWorld);
    bounds.add(field.originWorld +
               field.spacingWorld * glm::dvec3(field.dims[0] - 1, field.dims[1] - 1, field.dims[2] - 1));
    return bounds;
}

}  // namespace aeolic
