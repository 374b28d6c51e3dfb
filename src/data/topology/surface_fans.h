#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "data/mesh/mesh_edges.h"
#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// The fans of a surface, and angles in them. A fan is a run of corners at one point, counterclockwise, each beside the
/// next one: they share an edge of exactly two triangles that are wound alike. A point inside a surface has one closed
/// fan. A point on the boundary, or where sheets meet, has open ones.
///
/// Points in the same place count as one, so that a mesh that is split along its creases is whole again.
///
/// Angles around a closed fan are scaled so that they fill a circle (Knöppel, Crane, Pinkall and Schröder, "Globally
/// optimal direction fields", ACM TOG 32(4), 2013, section 6.1). Half-edges are those of mesh_edges.h.
struct SurfaceFans {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::vector<Triangle> triangles;   ///< The mesh's, with one index for points in the same place.
    std::vector<std::uint32_t> twin;   ///< [half-edges] the other one of the same edge, or kNone.
    std::vector<std::uint32_t> fanOf;  ///< [corners]
    std::vector<double> cornerRad;     ///< [corners] the triangle's own angle.
    std::vector<double> edgeRad;  ///< [corners] from the fan's first edge to the half-edge that begins here, scaled.
    std::vector<std::uint32_t> firstCorner;  ///< [fans]
    std::vector<double> scale;               ///< [fans] of angles; 1 for open ones.
    std::vector<std::uint8_t> closed;        ///< [fans]

    std::size_t fans() const { return firstCorner.size(); }

    /// The corner counterclockwise beside this one, or kNone.
    std::uint32_t nextCorner(std::uint32_t corner) const { return twin[previousInTriangle(corner)]; }

    /// Angle of the corner's second edge: that from the triangle's previous point, seen from the corner's.
    double secondEdgeRad(std::uint32_t corner) const
    {
        return edgeRad[corner] + scale[fanOf[corner]] * cornerRad[corner];
    }

    /// By how much the angle of a direction changes that is carried along a half-edge.
    double transportRad(std::uint32_t halfEdge) const;

    static std::uint32_t previousInTriangle(std::uint32_t halfEdge)
    {
        return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1;
    }
};

/// The corners of one fan, counterclockwise.
template <class Visit>
void forEachCorner(const SurfaceFans& fans, std::uint32_t fan, const Visit& visit)
{
    const std::uint32_t first = fans.firstCorner[fan];
    std::uint32_t corner = first;
    do {
        visit(corner);
        corner = fans.nextCorner(corner);
    } while (corner != SurfaceFans::kNone && corner != first);
}

/// Cost: O(triangles), and a sort of the points. Expects no degenerate triangles.
SurfaceFans surfaceFans(const SurfaceMesh& mesh);

/// An angle in (-π, π].
double wrapped(double rad);

}  // namespace aeolic
