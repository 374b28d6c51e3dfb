#pragma once

/// What tests ask of a mesh's shape. Points at the same position (bit by bit) count as one.

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "data/mesh/surface_mesh.h"

namespace aeolic {

struct MeshTopology {
    std::int64_t eulerCharacteristic = 0;  ///< Points - edges + triangles; unused points do not count.
    std::size_t boundaryEdges = 0;         ///< Edges of one triangle alone.
    std::size_t unevenEdges = 0;  ///< Edges of more than two triangles, or of two that are wound against each other.
};

inline MeshTopology topologyOf(const SurfaceMesh& mesh)
{
    using Bits = std::array<std::uint32_t, 3>;
    std::map<Bits, std::uint32_t> pointAt;
    const auto weld = [&](std::uint32_t index) {
        Bits bits;
        static_assert(sizeof(bits) == sizeof(glm::vec3));
        std::memcpy(bits.data(), &mesh.positions[index], sizeof bits);
        return pointAt.emplace(bits, std::uint32_t(pointAt.size())).first->second;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<int, 2>> directionsOf;
    for (const auto& triangle : mesh.triangles) {
        const std::array<std::uint32_t, 3> t{weld(triangle[0]), weld(triangle[1]), weld(triangle[2])};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::pair(t[i], t[(i + 1) % 3]);
            ++directionsOf[{std::min(a, b), std::max(a, b)}][a < b];
        }
    }
    MeshTopology topology;
    for (const auto& [edge, directions] : directionsOf) {
        const int faces = directions[0] + directions[1];
        topology.boundaryEdges += faces == 1;
        topology.unevenEdges += faces > 2 || (faces == 2 && directions[0] != 1);
    }
    topology.eulerCharacteristic =
        std::int64_t(pointAt.size()) - std::int64_t(directionsOf.size()) + std::int64_t(mesh.triangles.size());
    return topology;
}

/// Twice the area, towards the outside by the triangle's winding.
inline glm::dvec3 doubleAreaVector(const SurfaceMesh& mesh, const std::array<std::uint32_t, 3>& t)
{
    const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    return glm::cross(b - a, c - a);
}

inline double areaOf(const SurfaceMesh& mesh)
{
    double area = 0;
    for (const auto& t : mesh.triangles) area += 0.5 * glm::length(doubleAreaVector(mesh, t));
    return area;
}

/// The volume, by the divergence theorem; positive where triangles turn counter-clockwise seen from outside.
inline double volumeOf(const SurfaceMesh& mesh)
{
    double volume = 0;
    for (const auto& t : mesh.triangles) {
        volume += glm::dot(doubleAreaVector(mesh, t), glm::dvec3(mesh.positions[t[0]])) / 6;
    }
    return volume;
}

/// The smallest cosine between a triangle's own normal and the normals of its corners.
inline double worstNormalAgreement(const SurfaceMesh& mesh)
{
    double worst = 1;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 face = glm::normalize(doubleAreaVector(mesh, t));
        for (const std::uint32_t p : t) worst = std::min(worst, glm::dot(face, glm::dvec3(mesh.normals[p])));
    }
    return worst;
}

/// The largest difference of a normal's length from one.
inline double worstNormalLength(const SurfaceMesh& mesh)
{
    double worst = 0;
    for (const glm::vec3& n : mesh.normals) worst = std::max(worst, std::abs(double(glm::length(n)) - 1));
    return worst;
}

}  // namespace aeolic
