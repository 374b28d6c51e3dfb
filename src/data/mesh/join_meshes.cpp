#include "data/mesh/join_meshes.h"

#include <limits>

namespace aeolic {
namespace {

bool hasVectors(const SurfaceMesh& mesh)
{
    return !mesh.pointVectors.empty() || !mesh.cellVectors.empty();
}
bool hasScalars(const SurfaceMesh& mesh)
{
    return !mesh.pointScalars.empty() || !mesh.cellScalars.empty();
}
bool hasCellValues(const SurfaceMesh& mesh)
{
    return !mesh.cellVectors.empty() || !mesh.cellScalars.empty();
}

/// Appends the values of points; `without`: for those that have none.
template <class Value>
void append(std::vector<Value>& all, const std::vector<Value>& values, std::size_t points, const Value& without)
{
    all.insert(all.end(), values.begin(), values.end());
    all.resize(all.size() + points - values.size(), without);
}

/// The value of each triangle's corners: the triangle's own, or else the corners'.
template <class Value>
std::vector<Value> ofCorners(const SurfaceMesh& mesh, const std::vector<Value>& points, const std::vector<Value>& cells)
{
    std::vector<Value> values;
    if (points.empty() && cells.empty()) return values;
    values.reserve(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t corner : mesh.triangles[i])
            values.push_back(cells.empty() ? points[corner] : cells[i]);
    return values;
}

/// Every triangle with points of its own, which have its values.
SurfaceMesh withOwnCorners(const SurfaceMesh& mesh)
{
    SurfaceMesh apart;
    apart.originWorld = mesh.originWorld;
    apart.positions = ofCorners(mesh, mesh.positions, {});
    apart.normals = ofCorners(mesh, mesh.normals, {});
    apart.pointVectors = ofCorners(mesh, mesh.pointVectors, mesh.cellVectors);
    apart.pointScalars = ofCorners(mesh, mesh.pointScalars, mesh.cellScalars);
    apart.triangles.reserve(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) apart.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    return apart;
}

}  // namespace

SurfaceMesh joinMeshes(const std::vector<const SurfaceMesh*>& meshes, const glm::dvec3& originWorld)
{
    bool vectors = false, scalars = false;
    std::size_t points = 0, triangles = 0;
    for (const SurfaceMesh* mesh : meshes) {
        if (!mesh) continue;
        vectors = vectors || hasVectors(*mesh);
        scalars = scalars || hasScalars(*mesh);
        points += hasCellValues(*mesh) ? 3 * mesh->triangles.size() : mesh->positions.size();
        triangles += mesh->triangles.size();
    }
    SurfaceMesh all;
    all.originWorld = originWorld;
    all.positions.reserve(points);
    all.normals.reserve(points);
    all.surfaceOf.reserve(points);
    all.triangles.reserve(triangles);
    if (vectors) all.pointVectors.reserve(points);
    if (scalars) all.pointScalars.reserve(points);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (!meshes[i]) continue;
        SurfaceMesh apart;
        if (hasCellValues(*meshes[i])) apart = withOwnCorners(*meshes[i]);
        const SurfaceMesh& mesh = hasCellValues(*meshes[i]) ? apart : *meshes[i];
        const auto first = std::uint32_t(all.positions.size());
        const glm::dvec3 shift = mesh.originWorld - originWorld;
        for (const glm::vec3& p : mesh.positions) all.positions.emplace_back(glm::dvec3(p) + shift);
        all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({first + a, first + b, first + c});
        const std::size_t count = mesh.positions.size();
        if (vectors) append(all.pointVectors, mesh.pointVectors, count, glm::vec3(0));
        if (scalars) append(all.pointScalars, mesh.pointScalars, count, std::numeric_limits<float>::quiet_NaN());
        all.surfaceOf.resize(all.positions.size(), std::uint8_t(i));
    }
    return all;
}

}  // namespace aeolic
