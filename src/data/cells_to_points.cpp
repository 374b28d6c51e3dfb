#include "data/cells_to_points.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "base/parallel.h"
#include "data/mesh/mesh_edges.h"

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

/// The means of the triangles' values at the points; NaN where all of them are masked. `Sum`: the type of the sums.
template <class Sum, class Value>
std::vector<Value> meansAtPoints(const SurfaceMesh& mesh, const std::vector<Value>& values,
                                 const std::vector<double>& angles)
{
    std::vector<Sum> sums(mesh.positions.size(), Sum(0));
    std::vector<double> weights(mesh.positions.size(), 0);
    for (std::size_t t = 0; t < values.size(); ++t) {
        if (isMasked(values[t])) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = mesh.triangles[t][k];
            sums[point] += angles[3 * t + k] * Sum(values[t]);
            weights[point] += angles[3 * t + k];
        }
    }
    std::vector<Value> means;
    means.reserve(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) means.push_back(Value(sums[i] / weights[i]));
    return means;
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
        mesh_.copyPoint(point);
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
    const std::vector<double> angles = cornerAngles(mesh.triangles, mesh.positions);
    if (vectors) mesh.pointVectors = meansAtPoints<glm::dvec3>(mesh, mesh.cellVectors, angles);
    if (scalars) mesh.pointScalars = meansAtPoints<double>(mesh, mesh.cellScalars, angles);
    MaskedCorners masked(mesh, vectors, scalars);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) masked.split(t);
    mesh.cellVectors = {};
    mesh.cellScalars = {};
}

}  // namespace aeolic
