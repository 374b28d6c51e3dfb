#include "data/cells_to_points.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace aeolic {
namespace {

bool isMasked(float value)
{
    return std::isnan(value);
}
bool isMasked(const glm::vec3& value)
{
    return std::isnan(value.x + value.y + value.z);
}

std::vector<double> areasOf(const SurfaceMesh& mesh)
{
    std::vector<double> areas;
    areas.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
        areas.push_back(glm::length(glm::cross(q - p, r - p)));
    }
    return areas;
}

/// The means of the triangles' values at the points; NaN where all of them are masked. `Sum`: what is added up.
template <class Sum, class Value>
std::vector<Value> meansAtPoints(const SurfaceMesh& mesh, const std::vector<Value>& values,
                                 const std::vector<double>& areas)
{
    std::vector<Sum> sums(mesh.positions.size(), Sum(0));
    std::vector<double> weights(mesh.positions.size(), 0);
    for (std::size_t t = 0; t < values.size(); ++t) {
        if (isMasked(values[t])) continue;
        for (const std::uint32_t point : mesh.triangles[t]) {
            sums[point] += areas[t] * Sum(values[t]);
            weights[point] += areas[t];
        }
    }
    std::vector<Value> means;
    means.reserve(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) means.push_back(Value(sums[i] / weights[i]));
    return means;
}

template <class Value>
void copyPoint(std::vector<Value>& values, std::uint32_t point)
{
    if (values.empty()) return;
    const Value value = values[point];
    values.push_back(value);
}

/// Gives masked triangles points of their own, with masked values.
class MaskedCorners {
public:
    MaskedCorners(SurfaceMesh& mesh, bool vectors, bool scalars) : mesh_(mesh), vectors_(vectors), scalars_(scalars) {}

    void split(std::size_t triangle)
    {
        const bool vector = vectors_ && isMasked(mesh_.cellVectors[triangle]),
                   scalar = scalars_ && isMasked(mesh_.cellScalars[triangle]);
        if (!vector && !scalar) return;
        for (std::uint32_t& point : mesh_.triangles[triangle]) point = copyOf(point, vector, scalar);
    }

private:
    std::uint32_t copyOf(std::uint32_t point, bool vector, bool scalar)
    {
        const auto [found, isNew] =
            copies_.try_emplace({point, 2 * int(vector) + int(scalar)}, std::uint32_t(mesh_.positions.size()));
        if (!isNew) return found->second;
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        copyPoint(mesh_.positions, point);
        copyPoint(mesh_.normals, point);
        copyPoint(mesh_.pointVectors, point);
        copyPoint(mesh_.pointScalars, point);
        if (vector) mesh_.pointVectors.back() = glm::vec3(nan);
        if (scalar) mesh_.pointScalars.back() = nan;
        return found->second;
    }

    SurfaceMesh& mesh_;
    const bool vectors_, scalars_;
    std::map<std::pair<std::uint32_t, int>, std::uint32_t> copies_;
};

}  // namespace

void bringCellsToPoints(SurfaceMesh& mesh)
{
    const bool vectors = !mesh.cellVectors.empty(), scalars = !mesh.cellScalars.empty();
    if (!vectors && !scalars) return;
    const std::vector<double> areas = areasOf(mesh);
    if (vectors) mesh.pointVectors = meansAtPoints<glm::dvec3>(mesh, mesh.cellVectors, areas);
    if (scalars) mesh.pointScalars = meansAtPoints<double>(mesh, mesh.cellScalars, areas);
    MaskedCorners masked(mesh, vectors, scalars);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) masked.split(t);
    mesh.cellVectors = {};
    mesh.cellScalars = {};
}

}  // namespace aeolic
